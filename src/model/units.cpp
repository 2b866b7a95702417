// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/units.hpp"

#include <algorithm>
#include <cmath>

#include "model/path_inequality.hpp"

namespace brachisto {

namespace {

/// With the time for which 2 g = 1.
Units units_of(double length, const Scene& scene) {
  return {length, std::sqrt(length / (2.0 * scene.gravity))};
}

World in_units_of(const Units& units, World world) {
  const double acceleration = units.length / (units.time * units.time);
  if (world.sphere) {
    world.sphere->centre.x /= units.length;
    world.sphere->centre.z /= units.length;
    world.sphere->radius /= units.length;
    world.sphere->surface_gravity /= acceleration;
  }
  world.air.linear *= units.time;
  world.air.quadratic *= units.length;
  world.start_speed /= units.speed();
  return world;
}

}  // namespace

Units natural_units(const Scene& scene) {
  return units_of(std::max(scene.L, scene.H), scene);
}

Scene in_units_of(double length, const Scene& scene) {
  Scene scaled = scene;
  scaled.body.radius /= length;
  scaled.L /= length;
  scaled.H /= length;
  scaled.gravity = 0.5;
  scaled.limits = in_units_of(units_of(length, scene), scene.limits);
  if (!scene.world.ordinary()) {
    scaled.world = in_units_of(units_of(length, scene), scene.world);
  }
  return scaled;
}

Scene in_natural_units(const Scene& scene) {
  return in_units_of(natural_units(scene).length, scene);
}

PosedScene::PosedScene(const Scene& original)
    : asked(original),
      scene(without_whole_turns(original)),
      natural(in_natural_units(scene)),
      units(natural_units(scene)) {}

}  // namespace brachisto
