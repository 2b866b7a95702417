// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Who solves nonlinear programs: Ipopt, the interior-point solver, of which no
/// type stands here, and Newton's method on the optimality conditions as one
/// square system.

#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto {

/// Outcome of one run of a solver.
struct SolverResult {
  Status status = Status::InternalError;
  std::string message;  ///< in the solver's terms: what it said, and where
  PrimalDual point;     ///< the last iterate; empty if there was none
  int iterations = 0;
  int refused_points = 0;  ///< trial points at which the model is undefined
  /// What the chain factorisation took, in unknowns that are factorised once;
  /// an estimate, the same on all machines. 0 with another solver.
  double effort = 0.0;
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
  int max_iterations = 500;  ///< ≥ 0
  /// Ends it with Status::IterationLimit, converged or not: see
  /// SolverResult::effort, known while it runs with the chain factorisation.
  double most_effort = std::numeric_limits<double>::infinity();
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
/// Ipopt is a release with a way in, 3.11.9 or 3.14, and the same where this
/// was compiled and where it runs; else LinearSolver::Auto means MUMPS, and
/// LinearSolver::Chain ends with Status::InternalError and a message that says
/// why. The result tells which one it was, the verbose log why not the chain.
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

/// Options of solve_with_newton().
struct NewtonOptions {
  double tolerance = 1e-12;  ///< on the largest residual
  /// Go on below the tolerance as long as a step at least halves the residual.
  bool to_rounding = false;
  /// A residual that is all rounding: one step is made, but no second one.
  double rounding = 0.0;
  int max_iterations = 20;
  /// A step may be halved this often to make the residual fall.
  int max_halvings = 4;
  /// Mumps stands for the solver of any problem, which is sparse LU here. Chain
  /// is what Auto is: a step the chain cannot make is made by sparse LU.
  LinearSolver linear_solver = LinearSolver::Auto;
  /// A step that the chain cannot make is not made: where it cannot, the system
  /// is next to singular, and sparse LU takes long to say so.
  bool chain_alone = false;
  StopCondition stop;
};

/// Outcome of solve_with_newton().
struct NewtonResult {
  Status status = Status::NotConverged;
  PrimalDual point;  ///< best point seen
  double phi = 0.0;  ///< parameter of a tangency condition, which problems of
                     ///< this library have
  double residual = 0.0;        ///< largest residual there
  double first_residual = 0.0;  ///< largest residual at the start
  int iterations = 0;
  int chain_steps = 0;  ///< of these, by the chain factorisation
  /// Sign of the determinant of the system's Jacobian where the last step
  /// started: ±1, or 0 if it was singular or no step was made. It changes where
  /// a branch turns back, and between neighbouring branches.
  int determinant_sign = 0;
  /// False if the inequalities taken for equations are not those that hold at
  /// the point: then it is not solved.
  bool active_set_holds = true;
};

/// Newton's method for the unknowns (x, λ) on
///
///     ∂(f + λᵀg)/∂x_i = 0 (i free),  x_i given (i fixed),  g(x) = 0,
///
/// where inequalities take part as nlp::active_set() has them at the start:
/// those that hold as equations do so throughout, the others are left out, and
/// at the end the signs of the multipliers and the bounds left out are checked.
/// So it polishes what an interior-point method found, to values exactly on
/// their bounds, and does not search for the active set: where that is another
/// one the result says so and is not solved.
///
/// It works with exact derivatives, the chain factorisation or sparse LU (KLU),
/// and iterative refinement in long double, converges quadratically near a
/// solution and, unlike a minimiser, to any kind of stationary point: use it
/// where the start is close.
///
/// \return the point of the smallest residual, the start itself at worst
[[nodiscard]] NewtonResult solve_with_newton(nlp::Problem& problem,
                                             PrimalDual start,
                                             const NewtonOptions& options = {});

}  // namespace brachisto
