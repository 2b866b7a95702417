// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What an optimal-control problem is to the methods that solve it: a function
/// of one point, written once for any scalar.
///
/// Minimise ∫ L(y, u) ds subject to y' = f(y, u) and bounds of c(y, u). A point
/// is the states y and behind them the controls u. The function is asked
/// with numbers, with jets for derivatives, and with whatever else counts.

#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string_view>

namespace brachisto::ocp {

/// L and y' at a point.
template <class Scalar, std::size_t States>
struct Rates {
  Scalar cost{};
  std::array<Scalar, States> states{};
};

/// A function of the control with its first two derivatives by it.
template <class Scalar>
struct ByControl {
  Scalar value, first, second;
};

/// How many controls a problem has, as it says by `kControls`, or one.
template <class Problem>
consteval std::size_t num_controls() {
  if constexpr (requires { Problem::kControls; }) return Problem::kControls;
  return 1;
}

/// States and the controls behind them.
template <class Problem, class Scalar>
using PointOf = std::array<Scalar, Problem::kStates + num_controls<Problem>()>;

/// The bounds of one limit, lower ≤ c(y, u) ≤ upper; ±infinity: none.
struct Bounds {
  double lower, upper;
};

/// A problem is what has
///
/// - `kStates`, and `state_name(i)` of each; `kControls`, unless it is one;
/// - `rates(yu)`: L and f;
/// - `num_limits()`, and of each its `limit_name(i)`, its `bounds(i)` and its
///   value `limit(i, yu)`.
///
/// It may say by `refusal(yu, cost)` why a point of numbers is none of it, a
/// literal, or null if it is one. Without it cost and rates have to be finite.
template <class Problem, class Scalar = double>
concept ControlProblem = requires(const Problem& problem, std::size_t i,
                                  const PointOf<Problem, Scalar>& yu) {
  { Problem::kStates } -> std::convertible_to<std::size_t>;
  { problem.rates(yu) } -> std::same_as<Rates<Scalar, Problem::kStates>>;
  { problem.num_limits() } -> std::convertible_to<std::size_t>;
  { problem.limit(i, yu) } -> std::same_as<Scalar>;
  { problem.bounds(i) } -> std::same_as<Bounds>;
  { problem.state_name(i) } -> std::convertible_to<std::string_view>;
  { problem.limit_name(i) } -> std::convertible_to<std::string_view>;
};

/// What is integrated with its costates, step by step, has besides
///
/// - `costate_weight(i)`, what the error of a costate counts beside 1;
/// - `has_surface()`, on which rates have a kink, `height(y)` above it, and
///   `keep_to_side(above)`, which makes the law of one side that of both.
///
/// It may have closed forms of what jets of it are, where a measurement asks
/// for them: `jets<Jet>(yu)`, the rates with their derivatives by the point,
/// and `hamiltonian_by_control(y, u)`, L + p·f for states and costates y; and a
/// search of its own for the control that makes that least,
/// `least_control(y, near)`.
template <class Problem, class Scalar = double>
concept PointFunction = ControlProblem<Problem, Scalar> &&
    requires(const Problem& problem, std::size_t i,
             const PointOf<Problem, Scalar>& yu) {
  { problem.costate_weight(i) } -> std::same_as<double>;
  { problem.has_surface() } -> std::same_as<bool>;
  { problem.height(yu) } -> std::convertible_to<Scalar>;
};

/// How many of the first states nothing depends on, as a problem says it by
/// `kIgnorable`; their costates are constant (ignorable coordinates).
template <class Problem>
consteval std::size_t ignorable_states() {
  if constexpr (requires { Problem::kIgnorable; }) return Problem::kIgnorable;
  return 0;
}

/// The point with states and control as independent variables of jets.
///
/// \param yu  of numbers, or of any scalar that jets are made of
template <class Jet, class Scalar, std::size_t Size>
[[nodiscard]] std::array<Jet, Size> as_variables(
    const std::array<Scalar, Size>& yu) {
  std::array<Jet, Size> out;
  for (std::size_t i = 0; i < Size; ++i) {
    out[i] = Jet::variable(yu[i], static_cast<int>(i));
  }
  return out;
}

/// Calls put(i, c) for each limit of which asked(i); a description may have an
/// `each_limit` of its own, where limits share what they are made of.
template <class Problem, class Scalar, class Asked, class Put>
void each_limit(const Problem& problem, const PointOf<Problem, Scalar>& yu,
                Asked&& asked, Put&& put) {
  if constexpr (requires { problem.each_limit(yu, asked, put); }) {
    problem.each_limit(yu, asked, put);
  } else {
    for (std::size_t i = 0; i < problem.num_limits(); ++i) {
      put(i, asked(i) ? problem.limit(i, yu) : Scalar(0.0));
    }
  }
}

}  // namespace brachisto::ocp
