// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/letters.hpp"

namespace brachisto::report {

namespace {

/// Of each column, in letters; fmt would count bytes.
std::vector<std::size_t> widths_of(const Rows& rows, std::size_t least) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), least);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], letters(row[i]));
    }
  }
  return widths;
}

std::string room(const std::string& cell, std::size_t width) {
  return std::string(width - letters(cell), ' ');
}

}  // namespace

std::string text_table(const Rows& rows) {
  const std::vector<std::size_t> widths = widths_of(rows, 0);
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space = room(row[i], widths[i]);
      const bool left = i == 0 || i + 1 == row.size();
      line += (i == 0 ? "" : "  ") + (left ? row[i] + space : space + row[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

std::string markdown_table(const Rows& rows) {
  constexpr std::size_t kRule = 3;  // "---"
  const std::vector<std::size_t> widths = widths_of(rows, kRule);
  std::string text;
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += "| " + row[i] + room(row[i], widths[i]) + ' ';
    }
    text += "|\n";
    if (&row != &rows.front()) continue;
    for (const std::size_t width : widths) {
      text += "| " + std::string(width, '-') + ' ';
    }
    text += "|\n";
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

}  // namespace brachisto::report
