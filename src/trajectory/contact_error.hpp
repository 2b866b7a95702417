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
  const double at_A = std::hypot(start.x, start.z);
  const double at_B = std::hypot(end.x - scene.L, end.z - scene.H);
  // The larger of two may not be the one that is no number.
  return std::isnan(at_A + at_B) ? at_A + at_B : std::max(at_A, at_B);
}

}  // namespace brachisto
