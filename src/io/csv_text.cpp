// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "io/csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/expression.hpp"
#include "io/field_reader.hpp"

namespace brachisto::io {

std::string_view take_line(std::string_view& text) {
  const std::size_t length = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, length);
  text.remove_prefix(std::min(length + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

double number_of_cell(std::string_view cell, std::size_t line,
                      std::size_t column, std::string_view expected) {
  try {
    return evaluate(cell);
  } catch (const ExpressionError& error) {
    throw CsvError(fmt::format("{}:{}: {}", line, column,
                               not_a_number(cell, error, expected)));
  }
}

}  // namespace brachisto::io
