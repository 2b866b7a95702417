// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Options of a solve, as a problem file or a caller states them.

#pragma once

#include <cstdint>

#include "brachisto/paper/discrete_reading.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

/// How the extremal is found.
enum class Method {
  Ipopt,      ///< the nonlinear program
  NewtonKkt,  ///< the same by Newton's method on its optimality conditions
  Extremal,   ///< Pontryagin's conditions by multiple shooting, no program
  Fsolve,     ///< the paper's discrete system, for comparison; never verified
};

/// Who solves the paper's discrete system.
enum class FsolveVariant {
  Hybrid,  ///< Powell's hybrid method, dense differences: what fsolve does
  Newton,  ///< ε → 0, exact derivatives, dense Newton
  Lifted,  ///< the same steps from a sparse system with θ_j as unknowns
};

/// Options of Method::Fsolve.
struct FsolveOptions {
  DiscreteReading reading;  ///< its ε is for the variant Hybrid only
  FsolveVariant variant = FsolveVariant::Hybrid;
  /// On the Euclidean norm of the residual: the paper's.
  double tolerance = 1e-6;
};

/// Which of several extremals is the answer.
enum class Search {
  Principal,  ///< the one that continues from the cycloid as η_m grows from 0
  Global,     ///< the fastest verified and feasible contact found
};

/// Where the first iteration starts.
enum class Guess {
  Cycloid,   ///< the centre on the cycloid of the uniform cylinder
  Straight,  ///< the centre on the straight line between its end points
  Random,    ///< the cycloid with random slopes and speeds
};

/// Who gives a second opinion.
enum class Certify {
  None,
  Extremal,  ///< Pontryagin's conditions solved by multiple shooting
};

/// Bounds on the work; reaching one ends the solve with Status::IterationLimit
/// or Status::TimeLimit. A solve that cannot be done in this time, or in the
/// memory that there is, is not begun.
struct Limits {
  int iterations = 500;     ///< of the solver, in all passes together; ≥ 1
  double seconds = 3600.0;  ///< wall clock, > 0
};

inline constexpr double kSmallestResidual = 1e-14;
inline constexpr double kLargestResidual = 1e-6;

/// All options of solve(). The defaults are right for almost every scene.
struct SolveOptions {
  Discretisation discretisation;
  Method method = Method::Ipopt;
  LinearSolver linear_solver = LinearSolver::Auto;
  /// Scaled KKT residual, in [kSmallestResidual, kLargestResidual].
  double tolerance = 1e-12;
  Search search = Search::Principal;
  bool polish = true;  ///< last digits by Newton's method on the whole system
  Certify certify = Certify::None;
  Guess guess = Guess::Cycloid;
  std::uint64_t seed = 1;  ///< of Guess::Random
  Limits limits;
  FsolveOptions fsolve;  ///< of Method::Fsolve
};

}  // namespace brachisto
