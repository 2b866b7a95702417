// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Other worlds than a uniform field without air, left from rest.

#pragma once

#include <optional>

#include "brachisto/model/body.hpp"

namespace brachisto {

/// A homogeneous sphere that attracts: inside with a force that grows linearly
/// from its centre, outside with the inverse square of the distance.
struct Sphere {
  Point centre;                  ///< [m], z down
  double radius = 0.0;           ///< [m]
  double surface_gravity = 0.0;  ///< [m/s²]

  /// Strength of its field at a place [m/s²].
  [[nodiscard]] double strength_at(Point place) const;
};

/// Where a homogeneous sphere attracts by which law.
enum class SphereSide { Inside, Outside };

/// Drag on the centre, against its motion: c₁ v + c₂ v² per mass.
struct Air {
  double linear = 0.0;     ///< c₁ [1/s]
  double quadratic = 0.0;  ///< c₂ [1/m]

  [[nodiscard]] bool any() const { return linear != 0.0 || quadratic != 0.0; }
};

/// What acts on the body beside its track and a uniform field, and how fast it
/// sets out. As it stands, nothing and from rest.
struct World {
  /// In place of the uniform field. Its force at the centre of mass is that on
  /// the whole body: that it differs over the body is left out.
  std::optional<Sphere> sphere;
  Air air;
  double start_speed = 0.0;  ///< v₀ of the centre at A [m/s]

  /// Of the field, the rest being uniform: on the way from the uniform field to
  /// the sphere's. Otherwise 1.
  double sphere_share = 1.0;
  /// The law of the sphere on both sides of its surface, for a piece of path
  /// that lies on this one: it is smooth there. Otherwise nothing.
  std::optional<SphereSide> side;
  /// The slope of the track at A that the start was built from [rad], where it
  /// is an unknown and has been chosen; see slope_at_A_is_open().
  std::optional<double> start_slope;

  /// Rates of the motion differ from those of a uniform field without air.
  [[nodiscard]] bool changes_rates() const {
    return sphere.has_value() || air.any();
  }
  [[nodiscard]] bool ordinary() const {
    return !changes_rates() && start_speed == 0.0;
  }
};

}  // namespace brachisto
