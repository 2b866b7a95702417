// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Ranges that any formula for a generic Scalar takes, up to rounding.

#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>

#include "math/angle.hpp"

namespace brachisto::math {

/// All numbers from `lower` to `upper`. What is computed contains every value
/// of the formula; ends are rounded to nearest, so who compares leaves room.
struct Interval {
  double lower = 0.0, upper = 0.0;

  Interval() = default;
  template <std::convertible_to<double> Number>
  Interval(const Number& number)  // NOLINT: numbers are ranges
      : Interval(static_cast<double>(number), static_cast<double>(number)) {}
  Interval(double from, double to) : lower(from), upper(to) {}

  /// Its middle, by which a formula of two branches takes one.
  explicit operator double() const { return 0.5 * (lower + upper); }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return {a.lower + b.lower, a.upper + b.upper};
  }
  friend Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return a + (-b);
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const auto [least, most] =
        std::minmax({a.lower * b.lower, a.lower * b.upper, a.upper * b.lower,
                     a.upper * b.upper});
    return {least, most};
  }
  /// \pre 0 is not in b
  friend Interval operator/(const Interval& a, const Interval& b) {
    return a * Interval(1.0 / b.upper, 1.0 / b.lower);
  }
};

[[nodiscard]] inline Interval sin(const Interval& a) {
  const auto has = [&](double place) {
    return place + kTurn * std::ceil((a.lower - place) / kTurn) <= a.upper;
  };
  const auto [least, most] =
      std::minmax({std::sin(a.lower), std::sin(a.upper)});
  return {has(-0.25 * kTurn) ? -1.0 : least, has(0.25 * kTurn) ? 1.0 : most};
}
[[nodiscard]] inline Interval cos(const Interval& a) {
  return sin(a + 0.25 * kTurn);
}
[[nodiscard]] inline Interval sqrt(const Interval& a) {
  return {std::sqrt(a.lower), std::sqrt(a.upper)};
}

}  // namespace brachisto::math
