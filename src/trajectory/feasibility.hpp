// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether the body could run on a track.

#pragma once

#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

/// Whether R_n cannot be negative under limits: |R_t| ≤ μ R_n or a least R_n of
/// 0 or more. How well they are kept is for the certificate to judge.
[[nodiscard]] bool forbid_lift_off(const PathLimits& limits);

/// Whether the track folds by more than the error of its mesh, and runs back by
/// no less than kShortestFold.
[[nodiscard]] bool folds(const Scene& scene, const PathDiagnostics& path);

/// Why not: B lies inside the body at its start, the body would lift off
/// (R_n ≤ 0 for a u > 0, unless limits forbid it), the track folds (1 − r κ_c ≤
/// 0) or crosses itself; each with the place. Empty if none of that happens. A
/// bead on a wire may do all of it. Next to the start, where R_n is as small as
/// one likes, the signs of its limits there decide. What is no more than the
/// error of its mesh is no reason, nor are folds and loops of less than
/// kShortestFold.
///
/// That the body touches the track at a second place is not looked for.
[[nodiscard]] std::vector<std::string> infeasible_because(
    const Scene& scene, const PathDiagnostics& path);

/// What a finer mesh has to decide: R_n after its first rise or 1 − r κ_c,
/// where either is nearer to zero than its error on this one, on whichever
/// side; under limits on them what is beyond these between the points of a mesh
/// that knows no arcs.
[[nodiscard]] std::vector<std::string> undecided_because(
    const Scene& scene, const PathDiagnostics& path);

}  // namespace brachisto
