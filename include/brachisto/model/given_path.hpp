// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Paths that a scene states instead of asking for the extremal.

#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "brachisto/model/point.hpp"

namespace brachisto {

/// How far the points of a path may miss A and B: so much of L in x and of H in
/// z.
inline constexpr double kCloseToEnds = 1e-6;

/// A path that is evaluated, not optimised.
struct GivenPath {
  /// Whose curve it is.
  enum class Curve {
    Centre,  ///< of the path of the centre
    Track,   ///< of the track, from A to B
  };
  enum class Shape { Straight, Parabola, CircularArc, Cycloid, Points };

  Curve curve = Curve::Centre;
  Shape shape = Shape::Straight;
  /// Slope angle at the start, of a parabola or an arc [rad].
  std::optional<double> start_angle;
  std::vector<Point> points;  ///< of Shape::Points [m]

  /// True if the shape leaves the choice of the start angle.
  [[nodiscard]] bool has_start_angle() const {
    return shape == Shape::Parabola || shape == Shape::CircularArc;
  }
  /// The given one, or vertical.
  [[nodiscard]] double start_angle_or_vertical() const {
    return start_angle.value_or(0.5 * std::numbers::pi);
  }
};

}  // namespace brachisto
