// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The contacts of a body that starts with a speed.

#pragma once

#include <functional>

#include "refinement/mesh_solve.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// solve_on_mesh(), solve_near() or stay_on_mesh().
using SolveOnMesh = std::function<MeshSolution(
    Transcription& problem, MeshStart start, const MeshOptions& options)>;

/// What `solve` finds. Where slope_at_A_is_open() there is a slope α at A, from
/// which the place C_A(α) and w = v₀ √A(θ_m, α) of the start are built, beside
/// φ at B, and both are closed together,
///
///     β_start(α, φ) = α,  β_end(α, φ) = φ,
///
/// by Broyden's method around solutions between given ends; one of them closed
/// inside of the other would meet folds that both together do not have. The
/// first such solution is that of `solve`, the others Newton's method finds
/// from the one before.
///
/// \param problem  whose start has been built from a slope nearby; has that of
///                 the solution in the end
/// \param tolerance  on the mismatch at A [rad]
[[nodiscard]] MeshSolution close_start(RollingTime& problem, MeshStart start,
                                       const MeshOptions& options,
                                       const SolveOnMesh& solve,
                                       double tolerance = 1e-12);

/// dT/dα, by which the start moves and gets faster: with the costates there,
/// r (p_x cos α + p_z sin α) + p_w v₀ ∂√A/∂β; 0 if α is not open.
[[nodiscard]] double time_per_start_slope(const ExtremalCurve& curve);

}  // namespace brachisto
