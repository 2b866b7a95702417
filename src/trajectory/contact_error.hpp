// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far a path is from A and B.

#pragma once

#include <algorithm>
#include <cmath>

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// \param start, end  points of the curve that A and B are points of, in the
///                    units of the scene
[[nodiscard]] inline double contact_error(const Scene& scene, Point start,
                                          Point end) {
  const auto distance = [](Point a, Point b) {
    return std::hypot(a.x - b.x, a.z - b.z);
  };
  const double sum =
      distance(start, {0.0, 0.0}) + distance(end, {scene.L, scene.H});
  if (std::isnan(sum)) return sum;  // which the larger one may not be
  return std::max(distance(start, {0.0, 0.0}),
                  distance(end, {scene.L, scene.H}));
}

}  // namespace brachisto
