// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/failure.hpp"

#include <utility>

#include "brachisto/report/result_json.hpp"

namespace brachisto::app {

std::string failure_document(std::string_view status, std::string_view message,
                             nlohmann::ordered_json errors) {
  nlohmann::ordered_json document = {{"schema_version", report::kSchemaVersion},
                                     {"status", status},
                                     {"verified", false},
                                     {"message", message}};
  if (!errors.is_null()) document["errors"] = std::move(errors);
  return document.dump(2, ' ', false,
                       nlohmann::json::error_handler_t::replace) +
         "\n";
}

}  // namespace brachisto::app
