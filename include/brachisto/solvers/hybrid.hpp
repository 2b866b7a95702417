// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Powell's hybrid method for square systems.

#pragma once

#include "brachisto/solvers/square_system.hpp"

namespace brachisto {

/// Powell's hybrid method [Powell1970] as MINPACK has it (hybrd) and Eigen
/// ports it: dogleg steps in a trust region, a dense Jacobian by forward
/// differences at the start and whenever Broyden's updates of it fail twice.
/// What fsolve of SciPy runs, with its defaults: unbanded, steps to a relative
/// change of √ε.
///
/// Ends as soon as ‖F‖ ≤ tolerance, or by MINPACK's own tests. Points at which
/// F is not defined count as NaN, as they do there; from an undefined start
/// nothing is tried.
///
/// Time: N evaluations and O(N³) per Jacobian for N unknowns, O(N²) per update.
[[nodiscard]] SquareResult solve_by_hybrid(const SquareResidual& residual,
                                           std::vector<double> start,
                                           const SquareOptions& options);

/// Bytes of its dense matrices for N unknowns: Q, R and, while they are formed,
/// the factored Jacobian.
[[nodiscard]] constexpr double hybrid_memory_bytes(int num_unknowns) {
  return 3.0 * num_unknowns * num_unknowns * sizeof(double);
}

}  // namespace brachisto
