// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Other worlds than a uniform field without air, left from rest, and their
/// numbers.

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

/// What the track takes beside, in proportion to the load R_n. None is a gain:
/// paths keep R_n ≥ 0.
struct Losses {
  double sliding = 0.0;  ///< μ, Coulomb friction of a bead: the force μ R_n
  /// c, of what rolls: the moment c r R_n, of a ball c R R_n with its own
  /// radius
  double rolling = 0.0;

  /// Power per g R_n v_c: of either, for a body has but one of them. c of a
  /// ball is told of what its walls press in sum.
  [[nodiscard]] double factor(const Body& body) const {
    return sliding + rolling * body.wall_ratio;
  }
  [[nodiscard]] bool any() const { return sliding != 0.0 || rolling != 0.0; }
};

/// What acts on the body beside its track and a uniform field, and how fast it
/// sets out. As it stands, nothing and from rest.
struct World {
  /// In place of the uniform field. Its force at the centre of mass is that on
  /// the whole body: that it differs over the body is left out.
  std::optional<Sphere> sphere;
  Air air;
  Losses losses;
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

  /// The field depends on the place.
  [[nodiscard]] bool field_varies() const { return sphere.has_value(); }
  /// Energy is lost on the way.
  [[nodiscard]] bool brakes() const { return air.any() || losses.any(); }
  /// Rates of the motion differ from those of a uniform field without air and
  /// losses.
  [[nodiscard]] bool changes_rates() const {
    return field_varies() || brakes();
  }
  [[nodiscard]] bool ordinary() const {
    return !changes_rates() && start_speed == 0.0;
  }
};

/// Powers of the metre and the second.
struct Dimension {
  int length = 0;
  int time = 0;
};

/// What a number may be.
enum class Allowed { Any, Positive, NotNegative, Fraction };

/// One number of a World: what units, checks, problem files, words and the way
/// into a world know of it.
struct WorldParameter {
  const char* key;      ///< of problem files
  const char* meaning;  ///< in the words of their reference
  const char* unit;     ///< of SI
  Dimension dimension;
  Allowed allowed;
  const char* reason;  ///< why nothing else is
  /// The number, or nullptr where the world has no such part. One that has no
  /// part is 0 in an ordinary world, and grows on the way into another one.
  double* (*find_in)(World&);
  bool of_part = false;
  const char* times = "";  ///< of a drag: "v", "v²"

  [[nodiscard]] const double* find(const World& world) const {
    return find_in(const_cast<World&>(world));  // which changes nothing
  }
};

inline constexpr const char* kAirBrakes = "for air takes energy away";
inline constexpr const char* kTrackBrakes = "for the track takes energy away";

/// Each part's together, in the order of their checks.
inline constexpr WorldParameter kWorldParameters[] = {
    {"scene.field.sphere.radius",
     "R, its radius",
     "m",
     {1, 0},
     Allowed::Positive,
     "for the radius of a sphere is a length",
     [](World& w) { return w.sphere ? &w.sphere->radius : nullptr; },
     true},
    {"scene.field.sphere.surface_gravity",
     "its pull at the distance R",
     "m/s²",
     {1, -2},
     Allowed::Positive,
     "for the sphere attracts",
     [](World& w) { return w.sphere ? &w.sphere->surface_gravity : nullptr; },
     true},
    {"scene.field.sphere.centre.x",
     "to the right of A",
     "m",
     {1, 0},
     Allowed::Any,
     "",
     [](World& w) { return w.sphere ? &w.sphere->centre.x : nullptr; },
     true},
    {"scene.field.sphere.centre.z",
     "below A",
     "m",
     {1, 0},
     Allowed::Any,
     "",
     [](World& w) { return w.sphere ? &w.sphere->centre.z : nullptr; },
     true},
    {"scene.start.speed",
     "v_0, speed of the centre at A",
     "m/s",
     {1, -1},
     Allowed::NotNegative,
     "for its direction is the slope at A, which the extremal chooses",
     [](World& w) { return &w.start_speed; }},
    {"scene.air.linear",
     "c_1",
     "1/s",
     {0, -1},
     Allowed::NotNegative,
     kAirBrakes,
     [](World& w) { return &w.air.linear; },
     false,
     "v"},
    {"scene.air.quadratic",
     "c_2",
     "1/m",
     {-1, 0},
     Allowed::NotNegative,
     kAirBrakes,
     [](World& w) { return &w.air.quadratic; },
     false,
     "v²"},
    {"scene.losses.sliding",
     "μ, Coulomb friction of a bead",
     "",
     {},
     Allowed::NotNegative,
     kTrackBrakes,
     [](World& w) { return &w.losses.sliding; }},
    {"scene.losses.rolling",
     "c, rolling resistance of what rolls: its moment is c r R_n",
     "",
     {},
     Allowed::NotNegative,
     kTrackBrakes,
     [](World& w) { return &w.losses.rolling; }},
};

}  // namespace brachisto
