// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Method::Fsolve: the paper's discrete solution and what it is worth.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/study/certification.hpp"
#include "brachisto/study/fsolve_answer.hpp"

namespace brachisto {

/// n where a problem does not say, as in the paper.
inline constexpr int kDiscreteNodes = 100;

/// fsolve_answer() with the nodes, limits and reading of a solve.
[[nodiscard]] FsolveAnswer solve_discrete_system(const Scene& scene,
                                                 const SolveOptions& options,
                                                 const StopCondition& stop);

/// The extremal beside a discrete solution; `difference` is the latter's error.
[[nodiscard]] ExtremalOpinion opinion_on(const FsolveAnswer& answer,
                                         const ExtremalSolution& extremal);

/// The checks "discrete_residual" and "discretisation", the relative error of
/// τ. The latter is held against the accuracy that the other methods have by
/// default, which a discretisation of order one cannot reach: its solution is
/// compared with the extremal and never taken for it.
[[nodiscard]] Certificate certify_discrete(const FsolveAnswer& answer,
                                           const ExtremalOpinion& opinion);

}  // namespace brachisto
