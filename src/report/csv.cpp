// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

namespace brachisto::report {

bool begins_as_formula(std::string_view text) {
  return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) !=
                              std::string_view::npos;
}

std::string csv_field(std::string_view text) {
  const char* before = begins_as_formula(text) ? "'" : "";
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    return before + std::string(text);
  }
  std::string out = std::string("\"") + before;
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + '"';
}

}  // namespace brachisto::report
