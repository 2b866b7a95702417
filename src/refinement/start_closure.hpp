// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The contact at A of a body that starts with a speed.

#pragma once

#include <functional>

#include "refinement/mesh_solve.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// Solves a problem whose start is given.
using SolveFromStart = std::function<MeshSolution(const MeshStart& start)>;

/// What `solve` finds. Where slope_at_A_is_open() the slope α at A, from which
/// the place C_A(α) and w = v₀ √A(θ_m, α) of the start are built, is closed
/// around it: the extremal's own slope at its start has to be α. The first pass
/// is `solve`, the others are Newton's method from the one before.
///
/// \param problem  whose start has been built from a slope nearby; has that of
///                 the solution in the end
/// \param tolerance  on the mismatch at A [rad]
[[nodiscard]] MeshSolution close_start(RollingTime& problem,
                                       const MeshStart& start,
                                       const MeshOptions& options,
                                       const SolveFromStart& solve,
                                       double tolerance = 1e-12);

/// dT/dα, by which the start moves and gets faster: with the costates there,
/// r (p_x cos α + p_z sin α) + p_w v₀ ∂√A/∂β; 0 if α is not open.
[[nodiscard]] double time_per_start_slope(const ExtremalCurve& curve);

}  // namespace brachisto
