// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremals that compete for being the answer.

#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/solution.hpp"
#include "model/units.hpp"
#include "refinement/refinement.hpp"
#include "search/global_search.hpp"

namespace brachisto {

/// A branch, and the refinement and the checks it was judged by.
struct JudgedBranch {
  Branch branch;
  Refinement refinement;
  Certificate checks;
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

/// What is told of a path that was found and put to its checks.
///
/// \param infeasible  why the body cannot run on it; empty if it can
[[nodiscard]] Branch branch_of(const Motion& motion,
                               std::optional<double> estimated_error,
                               const Certificate& checks,
                               std::vector<std::string> infeasible);

/// Whether two refined solutions are one and the same, as far as their errors
/// tell.
[[nodiscard]] bool same(const Branch& a, const Branch& b);

/// 2: verified and feasible, 1: verified, 0: neither.
[[nodiscard]] int rank(const Branch& branch);

/// The fastest of the highest rank; null if there is none.
///
/// \param branches  fastest first, each with its `branch`
template <class Judged>
[[nodiscard]] Judged* best_branch(std::vector<Judged>& branches) {
  const auto best = std::ranges::max_element(
      branches, {}, [](const Judged& judged) { return rank(judged.branch); });
  return best == branches.end() ? nullptr : &*best;
}

}  // namespace brachisto
