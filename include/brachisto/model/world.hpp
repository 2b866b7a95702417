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

/// On which side of a surface where a field has a kink it has which law.
enum class FieldSide { Inside, Outside };

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
  /// In place of the uniform field, one at most. Its force at the centre of
  /// mass is that on the whole body: that it differs over the body is left out.
  std::optional<Sphere> sphere;
  Air air;
  Losses losses;
  double start_speed = 0.0;  ///< v₀ of the centre at A [m/s]

  /// Of that field, the rest being uniform: on the way from the uniform field
  /// to it. Otherwise 1.
  double field_share = 1.0;
  /// The law of this side on both sides of the field's surface, for a piece of
  /// path that lies there: it is smooth. Otherwise nothing.
  std::optional<FieldSide> side;
  /// The slope of the track at A that the start was built from [rad], where it
  /// is an unknown and has been chosen; see slope_at_A_is_open().
  std::optional<double> start_slope;

  /// found(field) of what stands in place of the uniform field, or uniform().
  template <class Uniform, class Found>
  [[nodiscard]] constexpr auto by_field(const Uniform& uniform,
                                        const Found& found) const {
    if (sphere) return found(*sphere);
    return uniform();
  }
  /// The field depends on the place.
  [[nodiscard]] bool field_varies() const {
    return by_field([] { return false; }, [](const auto&) { return true; });
  }
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

/// A field that may stand in place of the uniform one: what checks, problem
/// files and words know of it. Its formulas stand in model/field_formulas.hpp.
struct FieldKind {
  const char* key;            ///< of problem files; those of its numbers follow
  const char* meaning;        ///< in the words of their reference
  const char* place;          ///< the key of a place among them, or ""
  const char* place_meaning;  ///< of that
  const char* name;           ///< "the field of the sphere"
  const char* surface;        ///< where it has a kink, or ""
  const char* powerless;      ///< where nothing pulls at A
  /// Behind "at A", with its numbers {0}, {1}, ... in the order of
  /// kWorldParameters.
  const char* words;
  bool (*stands_in)(const World&);
  void (*put_into)(World&);
};

inline constexpr FieldKind kFieldKinds[] = {
    {"scene.field.sphere",
     "a homogeneous sphere: its pull grows linearly from its centre to its "
     "surface, and falls with the inverse square of the distance outside",
     "scene.field.sphere.centre", "where its centre is",
     "the field of the sphere", "the surface of the sphere",
     "the centre of the sphere is A, where nothing pulls",
     "of a sphere of {0:.6g} m about ({2:.6g}, {3:.6g})",
     [](const World& w) { return w.sphere.has_value(); },
     [](World& w) { w.sphere.emplace(); }},
};

/// Which of them a world has, or nullptr.
[[nodiscard]] inline const FieldKind* field_kind(const World& world) {
  for (const FieldKind& kind : kFieldKinds) {
    if (kind.stands_in(world)) return &kind;
  }
  return nullptr;
}

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
  /// The number, or nullptr where the world has no such field. One of no field
  /// is 0 in an ordinary world, and grows on the way into another one.
  double* (*find_in)(World&);
  bool of_field = false;
  /// Where it is not 0, {} being the number with its unit; of drags, which are
  /// told as one sum, "v" or "v²" behind it.
  const char* words = "";
  const char* times = "";

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
     [](World& w) { return &w.start_speed; },
     false,
     "v_0 = {}"},
    {"scene.air.linear",
     "c_1",
     "1/s",
     {0, -1},
     Allowed::NotNegative,
     kAirBrakes,
     [](World& w) { return &w.air.linear; },
     false,
     "",
     "v"},
    {"scene.air.quadratic",
     "c_2",
     "1/m",
     {-1, 0},
     Allowed::NotNegative,
     kAirBrakes,
     [](World& w) { return &w.air.quadratic; },
     false,
     "",
     "v²"},
    {"scene.losses.sliding",
     "μ, Coulomb friction of a bead",
     "",
     {},
     Allowed::NotNegative,
     kTrackBrakes,
     [](World& w) { return &w.losses.sliding; },
     false,
     "sliding friction {}"},
    {"scene.losses.rolling",
     "c, rolling resistance of what rolls: its moment is c r R_n",
     "",
     {},
     Allowed::NotNegative,
     kTrackBrakes,
     [](World& w) { return &w.losses.rolling; },
     false,
     "rolling resistance {}"},
};

}  // namespace brachisto
