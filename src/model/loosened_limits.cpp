// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/loosened_limits.hpp"

#include <cmath>

#include "model/limit_table.hpp"

namespace brachisto {

PathLimits loosened_limits(const Scene& scene, double by) {
  constexpr double kShrunk = 0.9;
  PathLimits limits = scene.limits;
  for (const LimitEntry& limit : limit_table()) {
    std::optional<double>& bound = limit.bound_in(limits);
    if (bound) bound = limit.loosened(scene, *bound, by);
  }
  for (Disc& disc : limits.discs) disc.radius *= 1.0 - kShrunk * by;
  for (HalfPlane& plane : limits.half_planes) {
    plane.point.x -= by * scene.H * std::cos(plane.normal);
    plane.point.z -= by * scene.H * std::sin(plane.normal);
  }
  return limits;
}

}  // namespace brachisto
