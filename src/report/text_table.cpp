// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "report/letters.hpp"
#include "report/rich_text.hpp"

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

/// Without what would end the cell.
std::string in_markdown(const std::string& cell) {
  return replaced(replaced(cell, "|", "\\|"), "\n", " ");
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

std::string markdown_table(const Rows& cells) {
  constexpr std::size_t kRule = 3;  // "---"
  Rows rows = cells;
  for (auto& row : rows) std::ranges::transform(row, row.begin(), in_markdown);
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

std::string table(const Rows& rows, TableForm form) {
  return form == TableForm::Markdown ? markdown_table(rows) : text_table(rows);
}

std::string or_dash(const std::optional<int>& value) {
  return value ? fmt::format("{}", *value) : "—";
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string seconds_text(double seconds) {
  return fmt::format("{:.3g}", seconds);
}

std::string memory_text(double bytes) {
  constexpr double kMegabyte = 1e6;
  return bytes > 0.0 ? fmt::format("{:.0f} MB", bytes / kMegabyte) : "—";
}

namespace {

// Beyond them a double has none.
constexpr int kDigits = 15;

bool is_known(double value, double error) {
  return std::isfinite(value) && std::isfinite(error) && error > 0.0;
}

/// Power of ten of the first digit.
int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Decimal places of the error's first digit, no more than the value has.
int decimals(double value, double error) {
  const int most = value == 0.0 ? kDigits : kDigits - 1 - exponent_of(value);
  return std::min(-exponent_of(error), most);
}

}  // namespace

std::string with_error(double value, double error) {
  if (!is_known(value, error)) return fmt::format("{:.12g}", value);
  int places = decimals(value, error);
  double units = std::ceil(error * std::pow(10.0, places));
  if (units >= 10.0) {  // 9.3 units are ten, one of the place before
    --places;
    units = 1.0;
  }
  // An error of one and more has no place behind the point.
  if (places < 0) return fmt::format("{:.0f} ± {:.0e}", value, error);
  return fmt::format("{:.{}f}({:.0f})", value, places, units);
}

std::string within_error(double value, double error) {
  if (!is_known(value, error)) return fmt::format("{:.12g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, decimals(value, error)));
}

std::string at_most(double bound) {
  std::string out = fmt::format("{:.1e}", bound);
  // A bound that is rounded down is none.
  for (double up = bound; std::stod(out) < bound;) {
    up *= 1.01;
    out = fmt::format("{:.1e}", up);
  }
  return out;
}

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
