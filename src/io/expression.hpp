// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers as problem files write them: literals or arithmetic of constants.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::io {

/// A number of the scene under the name that the notation gives it.
struct Quantity {
  std::string_view name;
  std::string_view path;  ///< dotted key of its value
};

inline constexpr std::array<Quantity, 6> kQuantities{{
    {"r", "scene.body.radius"},
    {"eta_m", "scene.body.eta_m"},
    {"theta_m", "scene.body.theta_m"},
    {"k", "scene.body.k"},
    {"L", "scene.finish.L"},
    {"H", "scene.finish.H"},
}};

/// Their values in one scene, in SI units and rad.
using QuantityValues = std::array<double, kQuantities.size()>;

/// Index of the quantity with a name, kQuantities.size() if there is none.
[[nodiscard]] constexpr std::size_t quantity_named(std::string_view name) {
  const auto found = std::ranges::find(kQuantities, name, &Quantity::name);
  return static_cast<std::size_t>(found - kQuantities.begin());
}

/// Index of the quantity that is the value of a key, or kQuantities.size().
[[nodiscard]] constexpr std::size_t quantity_of_key(std::string_view path) {
  const auto found = std::ranges::find(kQuantities, path, &Quantity::path);
  return static_cast<std::size_t>(found - kQuantities.begin());
}

/// A text is not a number; what() says why.
class ExpressionError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Whether a number may carry the suffix " deg" or " rad".
enum class Unit { None, Angle };

/// Whether an expression may name quantities of the scene.
enum class Names { None, Quantities };

/// Longest expression that is evaluated [bytes].
inline constexpr std::size_t kMaxExpressionLength = 200;

/// The names that an expression may have: pi, functions, quantities.
[[nodiscard]] std::vector<std::string_view> expression_names(Names names);

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

/// An expression that may name quantities, to be evaluated in many scenes.
/// Copies share what was prepared; several threads may evaluate one.
class Expression {
 public:
  /// \throws ExpressionError  as evaluate(), of a constant for its value too
  explicit Expression(std::string_view text, Unit unit = Unit::None,
                      Names names = Names::Quantities);

  /// As it was written, without blanks around it.
  [[nodiscard]] const std::string& text() const { return text_; }

  /// Indices of the quantities it names, none if it is a constant.
  [[nodiscard]] const std::vector<std::size_t>& quantities() const {
    return quantities_;
  }

  /// \throws ExpressionError  if it or a part of it is not finite
  [[nodiscard]] double value(const QuantityValues& values) const;

  /// Of a constant angle: the same direction within a turn. Whole turns are
  /// left out before degrees become radians, which is exact.
  [[nodiscard]] double direction() const;

  [[nodiscard]] bool in_degrees() const { return degrees_; }

 private:
  class Program;
  std::string text_;
  bool degrees_ = false;
  double constant_ = 0.0;  ///< in the unit it was written in
  std::vector<std::size_t> quantities_;
  std::shared_ptr<Program> program_;  ///< nullptr: a constant
};

}  // namespace brachisto::io
