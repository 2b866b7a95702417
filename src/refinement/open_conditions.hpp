// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a path of fixed arcs has to satisfy besides its optimality conditions.

#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "refinement/arcs.hpp"

namespace brachisto {

/// β_end − φ and β(0) less the slope that C_A is built from [rad], or what a
/// corner at A is off its bound, as far as the contact of the scene asks for
/// them.
struct ContactMismatch {
  double at_B = 0.0, at_A = 0.0;
  [[nodiscard]] double largest() const;
};
[[nodiscard]] ContactMismatch mismatch_of(LimitedCurve& curve,
                                          const LimitedEnds& ends);

/// Slope at the end: by transversality where no limit of the control holds at
/// the last point, otherwise the one the path ends with [rad].
[[nodiscard]] double end_slope(LimitedCurve& curve);

/// Whether the slope at B is a root.
[[nodiscard]] bool end_is_sought(const Scene& scene);

/// Whether the slope at A is an unknown of its own: a bounded valley takes time
/// to turn in, and a body that is pushed moves from the start.
[[nodiscard]] bool start_is_sought(const Scene& scene, const LimitedEnds& ends);

/// The ends with the slope at A as it is to be: one that is sought if a valley
/// is bounded and a limit holds the control from A on, and nothing but free
/// where the centre starts at A itself; else the one of start_angle_under(). On
/// a free arc nothing else would determine β(0). A corner is left out where no
/// limit holds the control.
/// Nothing if at rest no direction keeps the limits.
[[nodiscard]] std::optional<LimitedEnds> with_start(
    LimitedEnds ends, const Scene& scene,
    const std::vector<PathInequality>& limits, bool held_at_A);

/// What has to vanish besides the optimality conditions, one for each junction,
/// then for B and for A, as far as they are sought.
[[nodiscard]] Eigen::VectorXd open_conditions(LimitedCurve& curve,
                                              const std::vector<Arc>& arcs,
                                              const LimitedEnds& ends);

}  // namespace brachisto
