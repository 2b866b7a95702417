// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/world_check.hpp"

#include <cmath>
#include <string>

#include "model/field.hpp"

namespace brachisto {

namespace {

constexpr const char* kCentre = "scene.field.sphere.centre";
constexpr const char* kSpeed = "scene.start.speed";
constexpr const char* kLinear = "scene.air.linear";
constexpr const char* kQuadratic = "scene.air.quadratic";

/// Zero or positive.
void not_negative(const char* key, double value, const char* unit,
                  const char* reason, SceneChecker& check) {
  if (value == 0.0 || !check.finite(key, value)) return;
  if (value > 0.0) return check.representable(key, value, unit);
  check.add(key, fmt::format("{}{} is not allowed: it must be ≥ 0, {}", value,
                             unit, reason));
}

void check_sphere(const Scene& scene, SceneChecker& check) {
  const Sphere& sphere = *scene.world.sphere;
  check.positive("scene.field.sphere.radius", sphere.radius, " m",
                 "for the radius of a sphere is a length");
  check.positive("scene.field.sphere.surface_gravity", sphere.surface_gravity,
                 " m/s²", "for the sphere attracts");
  check.moderate("scene.field.sphere.centre.x", sphere.centre.x, " m");
  check.moderate("scene.field.sphere.centre.z", sphere.centre.z, " m");
  if (check.sound() && !(sphere.strength_at({0.0, 0.0}) > 0.0)) {
    check.add(kCentre,
              "the centre of the sphere is A, where nothing pulls, so that "
              "there is no g for τ = T √(2 g/H) to refer to");
  }
}

/// Where the centre's ends are the given points and no rotation enters, energy
/// alone says whether B can be reached.
void check_energy(const Scene& scene, SceneChecker& check) {
  const bool given_ends =
      !scene.body.rolls() ||
      (scene.contact == Contact::Centre && !scene.body.off_centred());
  if (!given_ends || !check.sound()) return;
  const double v_0 = scene.world.start_speed;
  const double at_start =
      0.5 * axisymmetric_inertia_factor(scene.body) * v_0 * v_0;
  const double gain = potential_fall(scene, {0.0, 0.0}, {scene.L, scene.H});
  if (at_start + gain > 0.0) return;
  check.add("scene.finish",
            fmt::format("B cannot be reached: its potential is {:.6g} m²/s² "
                        "above that of A, and the body starts with {:.6g}",
                        -gain, at_start));
}

/// What is derived for an ordinary world alone.
void check_company(const Scene& scene, SceneChecker& check) {
  const auto refuse = [&](const char* key, const char* reason) {
    check.add(key, fmt::format("not in a world with scene.field.sphere, "
                               "scene.start.speed or scene.air: {}",
                               reason));
  };
  if (scene.limits.any()) {
    refuse("scene.limits",
           "the static cone and the conditions where limits begin to hold are "
           "those of a body at rest in a uniform field without air");
  } else if (scene.contact == Contact::Optimal ||
             scene.contact == Contact::EndSlope) {
    refuse("scene.contact",
           "slopes that are free or given are well posed only with limits, "
           "which are those of a uniform field without air");
  }
  if (scene.path) {
    refuse("scene.path",
           "a given path is evaluated by the energy height alone, which knows "
           "neither losses nor another potential");
  }
}

}  // namespace

void check_world(const Scene& scene, SceneChecker& check) {
  const World& world = scene.world;
  if (world.ordinary()) return;
  if (world.sphere) check_sphere(scene, check);
  not_negative(kSpeed, world.start_speed, " m/s",
               "for its direction is the slope at A, which the extremal "
               "chooses",
               check);
  constexpr const char* kBrakes = "for air takes energy away";
  not_negative(kLinear, world.air.linear, " 1/s", kBrakes, check);
  not_negative(kQuadratic, world.air.quadratic, " 1/m", kBrakes, check);
  check_company(scene, check);
  check_energy(scene, check);
}

}  // namespace brachisto
