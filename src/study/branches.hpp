// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremals that compete for being the answer.

#pragma once

#include <string>
#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "model/units.hpp"
#include "refinement/refinement.hpp"
#include "search/global_search.hpp"

namespace brachisto {

/// A branch and the refinement it was judged by.
struct JudgedBranch {
  Branch branch;
  Refinement refinement;
};

/// Outcome of judge_branches().
struct JudgedBranches {
  std::vector<JudgedBranch> branches;  ///< fastest first
  /// All that were tried, those for candidates that dropped out included.
  std::vector<MeshRecord> meshes;
  Status failure = Status::NotConverged;  ///< of the last one without answer
};

/// Refines every candidate and judges it; those that turn out to be the same
/// extremal count once.
///
/// \param first_is_principal  whether candidates[0] is the principal one
/// \param options             the limit on iterations is for each candidate
[[nodiscard]] JudgedBranches judge_branches(
    const PosedScene& scene, const Discretisation& wanted,
    const std::vector<ContactCandidate>& candidates, bool first_is_principal,
    const MeshOptions& options);

/// The fastest that is verified and feasible; failing that, the fastest that is
/// verified; failing that, the fastest; null if there is none.
///
/// \param branches  fastest first
[[nodiscard]] JudgedBranch* best_branch(std::vector<JudgedBranch>& branches);

}  // namespace brachisto
