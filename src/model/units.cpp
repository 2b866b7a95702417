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

/// unit^power, for power ≥ 0; otherwise 1.
double power_of(double unit, int power) {
  double product = 1.0;
  for (; power > 0; --power) product *= unit;
  return product;
}

World in_units_of(const Units& units, World world) {
  for (const WorldParameter& parameter : kWorldParameters) {
    if (double* number = parameter.find_in(world)) {
      *number = units.measured(*number, parameter.dimension);
    }
  }
  return world;
}

}  // namespace

double Units::measured(double number, Dimension dimension) const {
  const double above =
      power_of(length, dimension.length) * power_of(time, dimension.time);
  const double below =
      power_of(length, -dimension.length) * power_of(time, -dimension.time);
  const bool per_unit = dimension.length <= 0 && dimension.time <= 0;
  return per_unit ? number * below : number / (above / below);
}

Units natural_units(const Scene& scene) {
  return units_of(std::max(scene.L, scene.H), scene);
}

Scene in_units_of(double length, const Scene& scene) {
  Scene scaled = scene;
  scaled.body.radius /= length;
  if (auto& ball = scaled.body.ball) {
    ball->radius /= length;
    for (std::optional<double>* width : {&ball->gauge, &ball->rail_radius}) {
      if (*width) **width /= length;
    }
  }
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
