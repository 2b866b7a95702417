// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Angles in degrees, and directions, which whole turns do not change.

#pragma once

#include <cmath>
#include <numbers>

namespace brachisto::math {

inline constexpr double kTurn = 2.0 * std::numbers::pi;

[[nodiscard]] constexpr double in_degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

/// The same direction within a turn: an angle [rad] up to 2π as it is, of a
/// larger one the equivalent in [−π, π], right to an ulp however large it is,
/// for sine and cosine reduce by π itself and not by the double next to it.
[[nodiscard]] inline double within_a_turn(double angle) {
  if (std::abs(angle) <= kTurn) return angle;
  return std::atan2(std::sin(angle), std::cos(angle));
}

/// The same direction in [−π, π]; what is there already stays as it is.
[[nodiscard]] inline double least_turn(double angle) {
  return std::abs(angle) <= std::numbers::pi ? angle
                                             : std::remainder(angle, kTurn);
}

}  // namespace brachisto::math
