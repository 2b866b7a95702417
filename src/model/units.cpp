// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/units.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto {

Units natural_units(const Scene& scene) {
  const double length = std::max(scene.L, scene.H);
  return {length, std::sqrt(length / (2.0 * scene.gravity))};
}

Scene in_units_of(double length, const Scene& scene) {
  Scene scaled = scene;
  scaled.body.radius /= length;
  scaled.L /= length;
  scaled.H /= length;
  scaled.gravity = 0.5;
  PathLimits& limits = scaled.limits;
  for (auto* curvature : {&limits.curvature.hump, &limits.curvature.valley}) {
    if (*curvature) **curvature *= length;
  }
  if (limits.floor) *limits.floor /= length;
  for (Disc& disc : limits.discs) {
    disc = {{disc.centre.x / length, disc.centre.z / length},
            disc.radius / length};
  }
  for (HalfPlane& plane : limits.half_planes) {
    plane.point = {plane.point.x / length, plane.point.z / length};
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
