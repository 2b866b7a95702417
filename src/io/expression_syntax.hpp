// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What expressions consist of, checked before muParser sees them: it would
/// also take assignments, comparisons, text, several results and names of its
/// own.

#pragma once

#include <span>
#include <string_view>

#include "io/expression.hpp"

namespace brachisto::io {

/// A function of one or of two numbers that expressions may call.
struct Function {
  std::string_view name;
  double (*of_one)(double);
  double (*of_two)(double, double) = nullptr;
};

/// All of them.
[[nodiscard]] std::span<const Function> functions();

/// The characters that separate tokens.
inline constexpr std::string_view kBlanks = " \t\n";

/// Reads the unsigned literal at the beginning of a text, correctly rounded.
/// \return its length, 0 if there is none
/// \throws ExpressionError  if a double cannot hold it
[[nodiscard]] std::size_t read_literal(std::string_view text, double& value);

/// Refuses what is not a literal, pi, a name, a function, an operator, a
/// parenthesis or a comma within parentheses.
/// \throws ExpressionError
void check_tokens(std::string_view text, Names names);

/// Refuses a sum outside of parentheses: `pi/2 - 30 deg` is meant otherwise
/// than (pi/2 − 30)°.
/// \throws ExpressionError
void check_no_sum(std::string_view text);

}  // namespace brachisto::io
