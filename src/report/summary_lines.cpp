// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/summary_lines.hpp"

#include <fmt/format.h>

#include <iterator>
#include <sstream>

namespace brachisto::report {

void add_line(std::string& out, std::string_view label,
              const std::string& text) {
  fmt::format_to(std::back_inserter(out), "  {:<16} {}\n", label, text);
}

void add_table(std::string& out, std::string_view label, const Rows& rows) {
  std::istringstream table(text_table(rows));
  for (std::string row; std::getline(table, row); label = "") {
    add_line(out, label, row);
  }
}

}  // namespace brachisto::report
