// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a command that failed says on stdout where a document is expected.

#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace brachisto::app {

/// The one document of a command with --json that has no result.
/// \param errors  mistakes in the input, if that is why
[[nodiscard]] std::string failure_document(std::string_view status,
                                           std::string_view message,
                                           nlohmann::ordered_json errors = {});

}  // namespace brachisto::app
