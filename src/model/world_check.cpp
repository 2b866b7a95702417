// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/scene_checker.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/contact.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "model/losses.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

constexpr const char* kSpeed = "scene.start.speed";
constexpr const char* kSliding = "scene.losses.sliding";
constexpr const char* kRolling = "scene.losses.rolling";
constexpr const char* kNormalMin = "scene.limits.normal_force.min";

/// Each number by itself: those of the field, or the others.
void check_numbers(const World& world, bool of_field, SceneChecker& check) {
  for (const WorldParameter& parameter : kWorldParameters) {
    const double* number = parameter.find(world);
    if (number == nullptr || parameter.of_field != of_field) continue;
    check.number(parameter.key, *number, parameter.unit, parameter.allowed,
                 parameter.reason);
  }
}

void check_field(const Scene& scene, SceneChecker& check) {
  const FieldKind* kind = field_kind(scene.world);
  if (kind == nullptr || !check.sound() || gravity_at_A(scene) > 0.0) return;
  check.add(*kind->place != '\0' ? kind->place : kind->key,
            fmt::format("{}, so that there is no g for τ = T √(2 g/H) to refer "
                        "to",
                        kind->powerless));
}

/// A scene's energy per mass at best, less what brakes it takes [m²/s²].
struct EnergyBound {
  double fall;      ///< of the potential from A to B, at most
  double at_start;  ///< ½ v₀² A(θ_m, β₀), at most
};

/// A bound for every slope at B, every angle θ_end, and where the slope at A
/// is_open for every β₀:
///
///     A(θ_m, β₀) ≤ (1 + η)² + k,
///     centre of mass at the start: C_A + r η e(θ_m), |C_A − A| = r,
///     centre of mass at the end: r (1 − η) to r (1 + η) from B,
///
/// or r η from it where B is the end of the centre's path. The start counts at
/// its place of most potential and the end at that of the least.
EnergyBound energy_bound(const Scene& scene, bool is_open) {
  const Body& body = scene.body;
  const double v_0 = scene.world.start_speed;
  const bool touches = body.rolls() && scene.contact != Contact::Centre;
  const double to_centre = touches ? body.radius : 0.0;
  const double to_mass = body.radius * body.eta_m;
  const double A = body.off_centred()
                       ? (1.0 + body.eta_m) * (1.0 + body.eta_m) + body.k
                       : axisymmetric_inertia_factor(body);
  const double fall = scene.world.by_field(
      [] { return 0.0; },
      [&](const auto& field) {
        const Point start =
            is_open ? fields::highest(
                          field, mass_centre(body, {0.0, 0.0}, body.theta_m),
                          to_centre)
                    : mass_centre(body, start_of_centre(scene), body.theta_m);
        const Point end =
            fields::lowest(field, {scene.L, scene.H},
                           std::abs(to_centre - to_mass), to_centre + to_mass);
        return potential_fall(scene, start, end);
      });
  return {fall, 0.5 * A * v_0 * v_0};
}

/// Energy says where B cannot be reached: in a field of places alone, for in a
/// uniform one B lies below A.
void check_energy(const Scene& scene, SceneChecker& check) {
  if (!scene.world.field_varies() || !check.sound()) return;
  const EnergyBound most = energy_bound(scene, slope_at_A_is_open(scene));
  const double missing = -(most.at_start + most.fall);
  if (missing < 0.0) return;
  // A body that is thrown may start where the one at rest does not.
  Scene thrown = scene;
  thrown.world.start_speed = 1.0;
  const EnergyBound by_speed = energy_bound(thrown, slope_at_A_is_open(thrown));
  const double least_speed =
      std::sqrt(std::max(0.0, -by_speed.fall / by_speed.at_start));
  check.add(
      "scene.finish",
      fmt::format(
          "B cannot be reached: {} potential is {:.6g} m²/s² higher "
          "there, and the body starts with {:.6g}{}, which is {:.6g} "
          "too little; {}",
          scene.body.rolls() ? "whatever its slope and angle there, the"
                             : "the",
          -most.fall, most.at_start,
          scene.world.brakes() ? ", of which more is lost" : "", missing,
          least_speed > 0.0 ? fmt::format("it takes a start.speed of more than "
                                          "{:.6g} m/s, if not of yet more",
                                          least_speed)
                            : "a start.speed can help"));
}

/// What only a body of the other kind loses by, and what would gain by pulling
/// at its track.
void check_losses(const Scene& scene, SceneChecker& check) {
  const Losses& lost = scene.world.losses;
  const PathLimits& limits = scene.limits;
  if (!lost.any() || !check.sound()) return;
  if (scene.body.rolls() && lost.sliding != 0.0) {
    check.add(kSliding,
              "not allowed of a body that rolls, whose track takes energy by "
              "scene.losses.rolling alone");
  } else if (!scene.body.rolls() && lost.rolling != 0.0) {
    check.add(kRolling,
              "not allowed of a bead, which slides; its friction is "
              "scene.losses.sliding");
  } else if (!losses::bounded(scene.body, lost.factor(scene.body))) {
    check.add(
        kRolling,
        fmt::format(
            "{} is not allowed: it must be less than √(((1 + η_m² + k)/η_m)² "
            "− 4), or there are angles at which the load, which "
            "brakes the body and so swings its centre of mass "
            "against the track, has no bound{}",
            lost.rolling,
            scene.body.ball ? "; of a ball η_e and k_e, and c R/r_e "
                              "for c"
                            : ""));
  } else if (!scene.path && limits.normal_min && *limits.normal_min < 0.0) {
    check.add(
        kNormalMin,
        fmt::format("{} m g is not allowed with scene.losses: it must be ≥ 0, "
                    "for a track that pulls at the body would give it "
                    "energy",
                    *limits.normal_min));
  } else if (!scene.path && lost.rolling != 0.0 && !limits.friction &&
             !limits.normal_min) {
    check.add(kRolling,
              "not allowed without scene.limits.friction, or "
              "scene.limits.normal_force.min of 0 or more: a track that pulls "
              "at the body would give it energy, and the fastest one would");
  }
}

/// At a cusp the path bends without bound, and a body that moves there would
/// press on its track without bound.
void check_given_path(const Scene& scene, SceneChecker& check) {
  if (scene.world.start_speed > 0.0 &&
      scene.path->shape == GivenPath::Shape::Cycloid) {
    check.add(
        kSpeed,
        "not allowed with scene.path.shape: cycloid, whose cusp at A only "
        "a body at rest can leave");
  }
}

}  // namespace

void check_world(const Scene& scene, SceneChecker& check) {
  const World& world = scene.world;
  if (world.ordinary()) return;
  check_numbers(world, true, check);
  check_field(scene, check);
  check_numbers(world, false, check);
  check_losses(scene, check);
  // A given path tells itself where energy does not suffice.
  scene.path ? check_given_path(scene, check) : check_energy(scene, check);
}

}  // namespace brachisto
