// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers as problem files write them: literals or arithmetic of constants.

#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace brachisto::io {

/// A text is not a number; what() says why.
class ExpressionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Whether a number may carry the suffix " deg" or " rad".
enum class Unit { None, Angle };

/// Longest expression that is evaluated [bytes].
inline constexpr std::size_t kMaxExpressionLength = 200;

/// What an expression may consist of, for messages and the documentation.
[[nodiscard]] std::string expression_grammar();

/// Value of a literal or an expression, angles in rad.
///
/// Literals are rounded correctly ("0.1" is the double nearest to 1/10, "010"
/// is ten). Expressions know + - * / ^, parentheses, pi and the functions of
/// expression_grammar(); ^ binds to the right and stronger than a sign, so
/// -2^2 = −4. An angle is degrees or radians as a whole: a sum needs
/// parentheses before the suffix.
///
/// \throws ExpressionError  if the text is anything else, or if the value or
///         an intermediate one is not finite
[[nodiscard]] double evaluate(std::string_view text, Unit unit = Unit::None);

}  // namespace brachisto::io
