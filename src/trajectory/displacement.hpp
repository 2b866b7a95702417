// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What it costs to build a track a little wrong.

#pragma once

#include <vector>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// What the time changes by if a stretch of the path is displaced.
struct DisplacedStretch {
  TrajectoryPoint from, middle,
      to;  ///< by the length of the path of the centre
  /// Change of T [s]; ∞ if the body does not get over it.
  double raised = 0.0, lowered = 0.0;

  [[nodiscard]] double dearer() const;  ///< the larger of the two in amount
};

/// The path of the centre in `count` stretches of equal length, each in turn
/// displaced along its normal, which displaces the track below it as far, by
///
///     ε(s) = ±e (1 − x²)³,  x = (s − s_0)/w,  |x| ≤ 1,
///
/// s_0 its middle and w half its length. The time changes by
///
///     ΔT = ∫ (√(A*/A · w²/w*²) ds*/ds − 1) dt,
///     ds*/ds = √((1 − κ_c ε)² + ε'²),   β* = β + atan2(ε', 1 − κ_c ε),
///     θ* = θ + (s* − s)/r,
///     w*² = w² + 2 (fall from c_m to c_m*) − 2 ∫ (D* ds*/ds − D) ds,
///
/// D the drag on the centre per mass, at its speed w/√A or w*/√A*. The integral
/// is over the stretch, and on to B where the body is off-centred or in air,
/// for there it comes to B turned otherwise or slower. Nothing is left out; of
/// the first order in e it is zero wherever no limit holds (docs/building.md).
/// Of N rows of the motion it takes O(count N), O(N) if every integral ends
/// with its stretch.
///
/// \param height  e > 0 [m]
/// \return of each stretch from A on; empty with losses
[[nodiscard]] std::vector<DisplacedStretch> displaced_stretches(
    const Motion& motion, int count, double height);

}  // namespace brachisto
