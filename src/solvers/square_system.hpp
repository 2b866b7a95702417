// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Square systems F(x) = 0 and what their solvers have in common.

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// Computes F(x); both have the same size and do not alias. False if F is not
/// defined at x.
using SquareResidual =
    std::function<bool(std::span<const double> x, std::span<double> residual)>;

/// Options of all solvers of square systems.
struct SquareOptions {
  double tolerance = 1e-6;   ///< on the Euclidean norm of F
  int max_iterations = 500;  ///< ≥ 0
  StopCondition stop;
};

/// Outcome of all solvers of square systems.
struct SquareResult {
  Status status = Status::NotConverged;
  std::string message;     ///< how it ended
  std::vector<double> x;   ///< point of the smallest residual, or the start
  double residual = 0.0;   ///< Euclidean norm of F there; NaN if undefined
  int iterations = 0;      ///< steps taken
  int evaluations = 0;     ///< of F, those for differences of it included
  int jacobians = 0;       ///< formed
  int refused_points = 0;  ///< at which F is not defined
  /// First of these, from the start on; empty if there was none.
  std::vector<double> first_refused;
};

/// Solves F'(x) step = −F(x), F(x) being given. False if F' is singular or not
/// defined at x.
using NewtonCorrection = std::function<bool(std::span<const double> x,
                                            std::span<const double> residual,
                                            std::span<double> step)>;

/// Newton's method, a step being halved until ‖F‖ falls by the factor
/// 1 − 10⁻⁴ α at the share α of it, where points at which F is not defined do
/// not count as a fall. Whoever calls chooses the linear algebra.
[[nodiscard]] SquareResult solve_by_damped_newton(
    const SquareResidual& residual, const NewtonCorrection& correction,
    std::vector<double> start, const SquareOptions& options);

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
