// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The indirect method as a witness for the nonlinear program.

#pragma once

#include "extremal/shooting.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto::benchmarks {

/// Pontryagin's conditions by multiple shooting, continued from the cycloid
/// and through folds.
[[nodiscard]] ExtremalSolution ask_witness(const Scene& scene,
                                           double max_seconds);

/// How far two paths lie apart.
struct Difference {
  double tau = 0.0;    ///< |τ − τ'| / τ'
  double path = 0.0;   ///< sup over σ of the centre's distance, / max(L, H)
  double nodes = 0.0;  ///< the same over element ends, where T's order holds
  double angle = 0.0;  ///< at the end [rad]
};

[[nodiscard]] Difference compare(const Trajectory& found,
                                 const ExtremalSolution& witness);

}  // namespace brachisto::benchmarks
