// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Ipopt, the interior-point solver, seen from the outside: no type of its own
/// stands here.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// Outcome of one run of a solver.
struct SolverResult {
  Status status = Status::InternalError;
  std::string message;  ///< in the solver's terms: what it said, and where
  PrimalDual point;     ///< the last iterate; empty if there was none
  int iterations = 0;
  int refused_points = 0;  ///< trial points at which the model is undefined
  /// Which one was at work; never Auto after a run.
  LinearSolver linear_solver = LinearSolver::Auto;
  std::string log;  ///< the solver's own journal
};

/// Options of one run of Ipopt.
struct IpoptOptions {
  double tolerance = 1e-12;  ///< on the scaled KKT residual
  /// On multiplier times distance from the bound, each of which leaves as much
  /// in f; nothing: `tolerance`.
  std::optional<double> complementarity = {};
  int max_iterations = 500;        ///< ≥ 0
  bool check_derivatives = false;  ///< run Ipopt's own second-order checker at
                                   ///< the start; findings go to the log
  bool verbose = false;            ///< full iteration log instead of a summary
  LinearSolver linear_solver = LinearSolver::Auto;
  StopCondition stop;
};

/// Solves a problem with Ipopt from a primal–dual start.
///
/// With an empty start.lambda the multipliers are estimated by least squares
/// (a cold start); otherwise the start is taken as it is, multipliers of bounds
/// included (a warm start). With inequalities a cold start is moved into its
/// bounds, and a warm one begins with the barrier parameter that it belongs to.
/// Bounds are not relaxed: an interior has to exist.
///
/// The chain factorisation is used if the problem states a chain structure and
/// Ipopt is a release with a way in, 3.11.9, where this was compiled and where
/// it runs; else LinearSolver::Auto means
/// MUMPS, and LinearSolver::Chain ends with Status::InternalError and a message
/// that says why. The result tells which one it was, the verbose log why not
/// the chain.
///
/// MUMPS is not safe in threads, and the chain reaches Ipopt through a variable
/// of the process: a thread waits here for the runs of others, until
/// `options.stop` is met at the latest.
///
/// \return how it ended and the last iterate. An exception that the problem
///         throws ends the run and is rethrown from here.
[[nodiscard]] SolverResult solve_with_ipopt(nlp::Problem& problem,
                                            const PrimalDual& start,
                                            const IpoptOptions& options);

/// "3.11.9", and the version of MUMPS that Ipopt uses.
[[nodiscard]] std::string ipopt_version();
[[nodiscard]] std::string mumps_version();

}  // namespace brachisto
