// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The minimum next to a place, from first and second derivatives, for any
/// scalar: what a loop decides about a number it decides about all parts of
/// another scalar, such as the lanes of a vector.

#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace brachisto::math {

/// `a` where a condition holds, else `b`. Scalars other than plain numbers have
/// an overload of their own beside them; so of the next two.
template <std::floating_point Real>
[[nodiscard]] Real where(bool condition, Real a, Real b) {
  return condition ? a : b;
}
/// Whether a condition holds of all parts of a scalar.
[[nodiscard]] inline bool all(bool condition) {
  return condition;
}
/// The largest absolute value of any part; NaN if one is no number.
template <std::floating_point Real>
[[nodiscard]] double magnitude(Real number) {
  return static_cast<double>(std::abs(number));
}

/// The minimum nearest to `near` of a function that is told with its first two
/// derivatives: Newton's method, turned into descent where the function is not
/// convex, and kept from jumping over a neighbouring maximum by a bound on the
/// step. NaN if none is reached.
///
/// \param function  argument → {value, first, second derivative}
template <class Scalar, class Function>
[[nodiscard]] Scalar nearest_minimum(const Function& function,
                                     const Scalar& near) {
  constexpr double kLongestStep = 0.25;
  constexpr int kMaxSteps = 100;
  // The next step of Newton's method would be the square of this one times half
  // the third derivative over the second: less than the rounding of the first
  // over the second, however flat the function is.
  constexpr double kLastStep = 1e-9;
  const Scalar longest(kLongestStep);
  Scalar at = near;
  for (int i = 0; i < kMaxSteps; ++i) {
    const auto [value, first, second] = function(at);
    const auto convex = second > Scalar(0.0);
    Scalar step = where(convex, Scalar(-first / second),
                        where(first < Scalar(0.0), longest, Scalar(-longest)));
    step = where(step > longest, longest, step);
    step = where(step < -longest, Scalar(-longest), step);
    at = at + step;
    if (std::isnan(magnitude(at))) break;
    if (all(convex) && magnitude(step) < kLastStep) return at;
  }
  return Scalar(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace brachisto::math
