// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a limit means for the path that was found under it.

#pragma once

#include <optional>
#include <string>
#include <vector>

namespace brachisto {

struct Interval {
  double from = 0.0, to = 0.0;
};

/// A stretch of the path along which a limit holds as an equation.
struct ActiveArc {
  Interval sigma;  ///< places, see Motion::at()
  Interval u, t;   ///< [s]
  Interval x;      ///< of the point of the track [m]
};

/// A bound of scene.limits, on the answer's path.
struct LimitOnPath {
  std::string name;  ///< its key below scene.limits, "normal_force.min"
  /// As the scene states it; nothing of a half-plane, which has none.
  std::optional<double> bound;
  std::vector<ActiveArc> active;  ///< in the order of the path
  double least_slack = 0.0;       ///< distance from the bound, 0 if active
  double share_of_time = 0.0;     ///< of T, on the active arcs
  /// dτ/d(bound), the contacts moving along: the slope of τ over the bound. Of
  /// a half-plane by metre along its normal.
  std::optional<double> price;
  /// What the multiplier says: dτ/d(bound) with A, B and both slopes that the
  /// places of the centre follow from held.
  std::optional<double> price_at_fixed_contacts;
};

}  // namespace brachisto
