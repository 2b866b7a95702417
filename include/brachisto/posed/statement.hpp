// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is said of an optimal-control problem beside its formulas: names,
/// bounds, ends, guesses.

#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "brachisto/ocp/point_function.hpp"

namespace brachisto::ocp {

inline constexpr double kNoBound = std::numeric_limits<double>::infinity();

/// Where the search of a variable begins: a number, a function of the share of
/// the duration, from 0 to 1, or values at equal steps of it. Nothing: straight
/// from its start to its end, as far as they are given, within its bounds.
class Guess {
 public:
  using Function = std::function<double(double)>;

  Guess() = default;
  template <std::convertible_to<double> Number>
  Guess(Number value)  // NOLINT: a number is a guess
      : is_(static_cast<double>(value)) {}
  Guess(std::vector<double> values)  // NOLINT: so are values
      : is_(std::move(values)) {}
  template <class F>
  requires(std::is_invocable_r_v<double, F, double> &&
           !std::convertible_to<F, double>)
      Guess(F function)  // NOLINT: and a function
      : is_(Function(std::move(function))) {}

  [[nodiscard]] bool given() const { return is_.index() != 0; }
  /// By fewer than two values.
  [[nodiscard]] bool too_few() const;
  /// \throws std::invalid_argument  if there are too few values
  [[nodiscard]] double at(double share) const;

 private:
  std::variant<std::monostate, double, Function, std::vector<double>> is_;
};

/// A state, a control or a parameter.
struct Variable {
  std::string name;
  std::string unit = {};  ///< for tables and pictures
  double lower = -kNoBound, upper = kNoBound;
  /// Of a state, where it is given.
  std::optional<double> start = {}, end = {};
  Guess guess = {};
  /// A size that it has; 0: from bounds, ends and guess.
  double scale = 0.0;
};

/// A limit of the path or a condition of its ends: lower ≤ value ≤ upper.
struct Limit {
  std::string name;
  double lower = -kNoBound, upper = kNoBound;
};

/// How long it takes.
struct Duration {
  double lower = 0.0, upper = kNoBound;
  double guess = 1.0;

  [[nodiscard]] static Duration fixed(double value) {
    return {value, value, value};
  }
};

/// All that is said.
struct Statement {
  std::string name;
  std::vector<Variable> states, controls, parameters = {};
  std::vector<Limit> limits = {}, end_conditions = {};
  Duration duration = {};
  std::string time_unit = {};
};

/// What its scale, bounds, ends and guess tell of a variable's size, if they
/// do.
[[nodiscard]] std::optional<double> size_of(const Variable& variable);

/// Powers of two by which states, parameters behind them, and controls are
/// divided, next to their sizes.
[[nodiscard]] std::vector<double> scales_of(const Statement& statement);

/// \throws std::invalid_argument  a sentence that names what cannot be: an
/// empty
///         range, an end outside of it, a number that is not finite, a name
///         that is missing or used twice
void check(const Statement& statement);

}  // namespace brachisto::ocp
