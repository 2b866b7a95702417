// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/scene_checker.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "model/limit_table.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

namespace {

constexpr const char* kContact = "scene.contact";
constexpr const char* kEndSlope = "scene.contact.end_slope";
constexpr const char* kLimits = "scene.limits";
constexpr const char* kFriction = "scene.limits.friction";
constexpr const char* kLeastForce = "scene.limits.normal_force.min";
constexpr const char* kValley = "scene.limits.curvature.valley";
constexpr const char* kFoldMargin = "scene.limits.fold_margin";
constexpr const char* kFloor = "scene.limits.floor";
constexpr const char* kClearOf = "scene.limits.clear_of";

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Each number by itself.
void check_values(const Scene& scene, SceneChecker& check) {
  const PathLimits& limits = scene.limits;
  for (const LimitEntry& limit : limit_table()) {
    const std::optional<double>& bound = limit.bound(limits);
    if (!bound) continue;
    check.number(limit.key, *bound, limit.unit, limit.allowed, limit.reason);
  }
  check.known("scene.limits.curvature.of", limits.curvature.of,
              CurvatureLimit::Of::Centre);
  for (const Disc& disc : limits.discs) {
    check.moderate(kClearOf, disc.centre.x, " m");
    check.moderate(kClearOf, disc.centre.z, " m");
    check.positive(kClearOf, disc.radius, " m",
                   "for the radius of a disc is a length");
  }
  for (const HalfPlane& plane : limits.half_planes) {
    check.moderate(kClearOf, plane.point.x, " m");
    check.moderate(kClearOf, plane.point.z, " m");
    check.angle(kClearOf, plane.normal);
  }
  if (scene.contact != Contact::EndSlope) {
    if (scene.end_slope) {
      check.add(kEndSlope, "only a contact of a given slope at B has one");
    }
  } else if (!scene.end_slope) {
    check.add(kEndSlope, "missing: the slope of the track at B");
  } else if (check.finite(kEndSlope, *scene.end_slope) &&
             std::abs(*scene.end_slope) > std::numbers::pi) {
    check.add(kEndSlope,
              fmt::format(
                  "{} rad is not allowed: it must be from −π to π, for a track "
                  "that goes round in a loop is never an answer",
                  *scene.end_slope));
  }
}

/// What no body of this kind can keep to, or needs no limit for.
void check_body(const Scene& scene, SceneChecker& check) {
  const PathLimits& limits = scene.limits;
  const double r = scene.body.radius;
  if (!scene.body.rolls()) {
    if (limits.friction) {
      check.add(kFriction,
                "not allowed of a bead, which slides: its friction is "
                "scene.losses.sliding");
    }
    if (limits.fold_margin) {
      check.add(kFoldMargin,
                "not allowed of a bead, whose track is its path and cannot "
                "fold");
    }
  } else if (limits.curvature.valley &&
             valley_of_centre(scene.body, limits) == kUnbounded) {
    check.add(
        kValley,
        fmt::format(
            "{} 1/m is not allowed of the track: it must be less than 1/r = "
            "{} 1/m, for a body that rolls in a valley fits no "
            "sharper one, and the bound would bound nothing",
            *limits.curvature.valley, 1.0 / r));
  }
}

/// Without an offset R_t = −(k sin β + c R_n)/(1 + k), c of what rolling loses:
/// no slip while sin β ≤ M R_n with M = (μ (1 + k) − c)/k = tan β*,
/// R_n = cos β − v_c² κ_c/g, or
///
///     (v_c²/g) dβ/ds ≤ cos β − sin β/M = sin(β* − β)/sin β*.
///
/// At rest β ≤ β*, and at β = β* the slope cannot grow: it stays below β*
/// throughout, and so, short of a loop, does the mean slope of the centre's
/// path, dz ≤ M dx. A track that does not fold has the same slopes; and the
/// path from C_A(β*), where the smooth contact starts, to C_B(φ) has
///
///     Δz − M Δx = H − M L + r (1 − cos(φ − β*))/cos β* ≥ H − M L.
///
/// Either way H ≤ M L; with M ≤ 0 no slope leads down. Of a ball it is μ R/r_e
/// that stands for μ, and c R/r_e for c.
///
/// Asked in the uniform field, without a drag that helps to hold the body.
void check_grade(const Scene& scene, SceneChecker& check) {
  const World& world = scene.world;
  if (!scene.limits.friction || world.field_varies() || world.air.any()) return;
  const double k = scene.body.k;
  const double lost = world.losses.factor(scene.body);
  const double least =
      (k * (scene.H / scene.L) + lost) / (1.0 + k) / scene.body.wall_ratio;
  const double mu = *scene.limits.friction;
  if (mu >= least * (1.0 - kBoundSlack)) return;
  check.add(
      kFriction,
      fmt::format("{} is not allowed: it must be at least {} = {}, for "
                  "the slope of a track on which the body does not slip "
                  "never exceeds arctan({}), and B lies deeper{}",
                  mu, lost > 0.0 ? "(k H/L + c)/(1 + k)" : "(k/(1 + k)) H/L",
                  least, lost > 0.0 ? "(μ (1 + k) − c)/k" : "μ (1 + k)/k",
                  !scene.body.ball ? ""
                  : lost > 0.0     ? "; of a ball k_e, and μ and c times R/r_e"
                                   : "; of a ball k_e, and μ R/r_e for μ"));
}

/// Forces at rest, which depend on the direction of the start alone.
void check_start(const Scene& scene, SceneChecker& check) {
  const Body& body = scene.body;
  const PathLimits& limits = scene.limits;
  if (!body.off_centred()) {
    // What friction allows then contains flat slopes, on which R_n is near 1.
    if (limits.normal_min && *limits.normal_min >= 1.0) {
      check.add(kLeastForce,
                fmt::format(
                    "{} m g is not allowed: it must be less than 1 without an "
                    "offset of the centre of mass, for the body starts "
                    "from rest on a slope, where R_n = cos β < 1",
                    *limits.normal_min));
    }
    // Losses hold a body on flat slopes.
    if (!scene.world.losses.any()) return check_grade(scene, check);
    if (!check.sound()) return;
  }
  const auto starts = [&](bool under_friction, bool under_force) {
    PathLimits some;
    if (under_friction) some.friction = limits.friction;
    if (under_force) {
      some.normal_min = limits.normal_min;
      some.normal_max = limits.normal_max;
    }
    return start_angle_under(scene, inequalities(body, some)).has_value();
  };
  constexpr const char* kNoDirection =
      "{} is not allowed{}: whatever the slope of the track at A, the body "
      "would "
      "{} at rest, or not start";
  if (starts(true, true)) {
    if (!body.off_centred()) check_grade(scene, check);
    return;
  }
  if (!starts(false, true)) {
    check.add(kLeastForce, fmt::format(kNoDirection, *limits.normal_min, "",
                                       "press less on it"));
  } else {
    check.add(kFriction,
              fmt::format(kNoDirection, *limits.friction,
                          starts(true, false) ? " with these limits of "
                                                "normal_force"
                                              : "",
                          "slip"));
  }
}

/// The contacts whose fastest tracks are none without limits.
void check_contact(const Scene& scene, SceneChecker& check) {
  const PathLimits& limits = scene.limits;
  const double hump = hump_of_centre(scene.body, limits);
  const bool turns_gently =
      scene.body.rolls() ? hump < 1.0 / scene.body.radius : hump < kUnbounded;
  const bool valley = valley_of_centre(scene.body, limits) < kUnbounded;
  if (scene.contact == Contact::Optimal && scene.body.rolls()) {
    if (!turns_gently) {
      check.add(kContact,
                "optimal is not allowed without limits.curvature.hump (of the "
                "centre: below 1/r) or a limits.fold_margin > 0: there is no "
                "fastest track, for at A it would fold into a kink");
    }
    if (!valley && !limits.normal_max) {
      check.add(kContact,
                "optimal is not allowed without limits.curvature.valley or "
                "limits.normal_force.max: there is no fastest track, for the "
                "more sharply it turns upwards at its ends, the faster it is");
    }
  }
  if (scene.contact == Contact::EndSlope && !(turns_gently && valley)) {
    check.add(kEndSlope,
              "not allowed without limits.curvature.hump (of the centre: below "
              "1/r; or a limits.fold_margin > 0) and limits.curvature.valley: "
              "a track without such bounds would turn to its last slope in a "
              "kink at B");
  }
}

bool slope_at_B_is_free(const Scene& scene) {
  return scene.contact == Contact::Smooth || scene.contact == Contact::Optimal;
}

void check_floor(const Scene& scene, SceneChecker& check) {
  const double floor = *scene.limits.floor;
  const double r = scene.body.radius;
  const double R = scene.body.outer_radius();
  const auto refuse = [&](const char* relation, double bound,
                          std::string_view reason) {
    check.add(kFloor, fmt::format("{} m is not allowed: it must be {} {} m, {}",
                                  floor, relation, bound, reason));
  };
  if (slope_at_B_is_free(scene) && r > 0.0) {
    if (floor <= scene.H + (R - r)) {
      return refuse(
          scene.body.ball ? "more than H + R − r_e =" : "more than H =",
          scene.H + (R - r),
          "for a body that stands at B on a slope, however gentle, "
          "reaches lower than B");
    }
  } else {
    const double lowest = scene.contact == Contact::Centre ? R
                          : slope_at_B_is_free(scene)
                              ? 0.0
                              : R - r + r * (1.0 - std::cos(*scene.end_slope));
    const double least = scene.H + lowest;
    if (floor < least - kBoundSlack * (scene.H + r)) {
      return refuse("at least", least, "which the body reaches at B");
    }
  }
  // With a valley bound, or optimal, the slope at A is a matter of the whole
  // track; otherwise of the start alone.
  const bool of_the_start =
      scene.world.start_speed == 0.0 &&
      (scene.contact == Contact::Smooth ||
       scene.contact == Contact::EndSlope) &&
      valley_of_centre(scene.body, scene.limits) == kUnbounded;
  if (!of_the_start || r == 0.0) return;
  const auto slope =
      start_angle_under(scene, inequalities(scene.body, scene.limits));
  if (!slope) return;
  const double lowest = R - r + r * (1.0 - std::cos(*slope));
  if (floor > lowest) return;
  refuse("more than", lowest, "which the body reaches at the start");
}

/// A and B themselves; whether the body has room there, the solver sees.
void check_clearance(const Scene& scene, SceneChecker& check) {
  const bool of_centre = scene.contact == Contact::Centre;
  const double needed = of_centre ? scene.body.outer_radius() : 0.0;
  struct End {
    char name;
    Point at;
  };
  for (const End& end : {End{'A', {0.0, 0.0}}, End{'B', {scene.L, scene.H}}}) {
    const auto keep_off = [&](const char* what, std::size_t index,
                              double distance) {
      if (distance >= needed) return;
      check.add(
          kClearOf,
          fmt::format(
              "{} number {} is not allowed: {} = ({}, {}) lies {} "
              "it, and the {} there",
              what, index + 1, end.name, end.at.x, end.at.z,
              of_centre ? "within r of" : "in",
              of_centre ? "centre of the body is" : "body touches the track"));
    };
    for (std::size_t i = 0; i < scene.limits.discs.size(); ++i) {
      const Disc& disc = scene.limits.discs[i];
      keep_off("disc", i, distance(end.at, disc.centre) - disc.radius);
    }
    for (std::size_t i = 0; i < scene.limits.half_planes.size(); ++i) {
      const HalfPlane& plane = scene.limits.half_planes[i];
      const double off = (end.at.x - plane.point.x) * std::cos(plane.normal) +
                         (end.at.z - plane.point.z) * std::sin(plane.normal);
      // As of a floor: the centre is r_e from the track.
      const double reach = scene.body.outer_radius() - scene.body.radius;
      const double rounding = kBoundSlack * (scene.L + scene.H);
      if (end.name == 'B' && scene.body.rolls() && slope_at_B_is_free(scene) &&
          off >= -rounding && off <= reach + rounding) {
        check.add(
            kClearOf,
            fmt::format("half_plane number {} is not allowed: B = ({}, {}) "
                        "lies {:.6g} m from its edge; it must be more than "
                        "{:.6g} m, for a body that stands at B on any slope "
                        "but that of the edge reaches further",
                        i + 1, end.at.x, end.at.z, off <= rounding ? 0.0 : off,
                        reach));
      } else {
        keep_off("half_plane", i, off);
      }
    }
  }
}

}  // namespace

void check_limits(const Scene& scene, SceneChecker& check) {
  const PathLimits& limits = scene.limits;
  check_values(scene, check);
  const bool known_contact =
      scene.contact == Contact::Smooth || scene.contact == Contact::Centre;
  if ((known_contact && !limits.any()) || !check.sound()) return;
  if (scene.path) {
    if (limits.any()) {
      check.add(kLimits,
                "not allowed with scene.path: a given path is "
                "evaluated as it is, and bound by nothing");
    }
    if (!known_contact) {
      check.add(kContact,
                "not allowed with scene.path: a given path has its "
                "slopes at A and B already; smooth or centre is");
    }
    return;
  }
  check_body(scene, check);
  if (limits.normal_min && limits.normal_max &&
      *limits.normal_min >= *limits.normal_max) {
    check.add(
        kLeastForce,
        fmt::format(
            "{} m g is not allowed: it must be less than max = {} m g, or "
            "no track is left",
            *limits.normal_min, *limits.normal_max));
  }
  check_contact(scene, check);
  // A body that is pushed is bound by no law of rest.
  if (check.sound() && scene.world.start_speed == 0.0) {
    check_start(scene, check);
  }
  if (limits.floor && check.sound()) check_floor(scene, check);
  check_clearance(scene, check);
}

}  // namespace brachisto
