// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Comma-separated values, line by line.

#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>

namespace brachisto::io {

/// A text does not hold what it should; what() begins with line:column.
class CsvError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Takes the first line off a text, its end included, and returns it without.
[[nodiscard]] std::string_view take_line(std::string_view& text);

/// The number in a cell, which may be an expression.
///
/// \param line, column  where the cell begins, from 1
/// \param expected      what should stand there, for messages
/// \throws CsvError
[[nodiscard]] double number_of_cell(std::string_view cell, std::size_t line,
                                    std::size_t column,
                                    std::string_view expected);

}  // namespace brachisto::io
