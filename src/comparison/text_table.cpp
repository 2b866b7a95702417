// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/letters.hpp"

namespace brachisto::comparison {

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], report::letters(row[i]));
    }
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      // fmt would count bytes.
      const std::string room(widths[i] - report::letters(row[i]), ' ');
      const bool left = i == 0 || i + 1 == row.size();
      line += (i == 0 ? "" : "  ") + (left ? row[i] + room : room + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string or_dash(const std::optional<int>& value) {
  return value ? fmt::format("{}", *value) : "—";
}

std::string seconds_text(double seconds) {
  return fmt::format("{:.3g}", seconds);
}

std::string memory_text(double bytes) {
  constexpr double kMegabyte = 1e6;
  return bytes > 0.0 ? fmt::format("{:.0f} MB", bytes / kMegabyte) : "—";
}

}  // namespace brachisto::comparison
