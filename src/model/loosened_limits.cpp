// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/loosened_limits.hpp"

#include <algorithm>
#include <cmath>

namespace brachisto {

PathLimits loosened_limits(const Scene& scene, double by) {
  constexpr double kTimes = 20.0, kWeights = 2.0, kShrunk = 0.9;
  // A valley of the track that is as sharp as the body bounds nothing.
  constexpr double kSharpest = 0.99;
  PathLimits limits = scene.limits;
  const double factor = std::pow(kTimes, by);
  if (limits.friction) *limits.friction *= factor;
  if (limits.normal_min) {
    // A body that must not lift off does not.
    const double least = *limits.normal_min - kWeights * by;
    limits.normal_min =
        *limits.normal_min >= 0.0 ? std::max(0.0, least) : least;
  }
  if (limits.normal_max) *limits.normal_max += kWeights * by;
  CurvatureLimit& curvature = limits.curvature;
  if (curvature.valley) {
    const double asked = *curvature.valley;
    curvature.valley = factor * asked;
    if (curvature.of == CurvatureLimit::Of::Track && scene.body.rolls()) {
      curvature.valley = std::max(
          asked, std::min(factor * asked, kSharpest / scene.body.radius));
    }
  }
  if (scene.contact != Contact::Optimal) {
    if (curvature.hump) *curvature.hump *= factor;
    if (limits.fold_margin) *limits.fold_margin *= 1.0 - by;
  }
  if (limits.floor) *limits.floor += by * scene.H;
  for (Disc& disc : limits.discs) disc.radius *= 1.0 - kShrunk * by;
  for (HalfPlane& plane : limits.half_planes) {
    plane.point.x -= by * scene.H * std::cos(plane.normal);
    plane.point.z -= by * scene.H * std::sin(plane.normal);
  }
  return limits;
}

}  // namespace brachisto
