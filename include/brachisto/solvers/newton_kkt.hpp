// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method on the optimality conditions as one square system.

#pragma once

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/solvers/status.hpp"

namespace brachisto::nlp {

class TangencyCondition;  // of this library's own problems

}  // namespace brachisto::nlp

namespace brachisto {

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
  PrimalDual point;             ///< best point seen
  double phi = 0.0;             ///< parameter of the tangency condition there
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

/// Newton's method for the unknowns (x, λ, φ) on
///
///     ∂(f + λᵀg)/∂x_i = 0 (i free),  x_i = value_i(φ) (i fixed),
///     g(x) = 0,  F(x, λ, φ) = 0,
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
/// \param tangency  may be null: then there is no φ
/// \return the point of the smallest residual, the start itself at worst
[[nodiscard]] NewtonResult solve_with_newton(nlp::Problem& problem,
                                             nlp::TangencyCondition* tangency,
                                             PrimalDual start, double phi,
                                             const NewtonOptions& options);

}  // namespace brachisto
