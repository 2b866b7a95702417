// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Options of a solve, as a problem file or a caller states them.

#pragma once

#include <cstdint>
#include <variant>

#include "brachisto/paper/discrete_reading.hpp"
#include "brachisto/solvers/linear_solver.hpp"
#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

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

/// What an answer is cross-checked by.
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

/// Who solves the nonlinear program.
enum class ProgramSolver {
  Ipopt,
  NewtonKkt,  ///< Newton's method on the optimality conditions
};

/// The optimal-control problem made finite: a nonlinear program.
struct Collocation {
  Discretisation discretisation = {};
  ProgramSolver solver = ProgramSolver::Ipopt;
  LinearSolver linear_solver = LinearSolver::Auto;
  /// Scaled KKT residual, in [kSmallestResidual, kLargestResidual].
  double tolerance = 1e-12;
  Search search = Search::Principal;
  bool polish = true;  ///< last digits by Newton's method on the whole system
  Certify certify = Certify::None;
  Guess guess = Guess::Cycloid;
  std::uint64_t seed = 1;  ///< of Guess::Random
};

/// The indirect method: Pontryagin's conditions by multiple shooting.
struct Shooting {
  double tolerance = kDefaultTolerance;  ///< wanted relative error of T
};

/// Who solves the paper's discrete system.
enum class DiscreteSolver {
  Hybrid,  ///< Powell's hybrid method, dense differences: what fsolve does
  Newton,  ///< ε → 0, exact derivatives, dense Newton
  Lifted,  ///< the same steps from a sparse system with θ_j as unknowns
};

/// The paper's discrete system, for comparison; its answer is never verified.
struct DiscreteSystem {
  int nodes = 100;  ///< n ≥ kFewestDiscreteNodes; 100 in the paper
  DiscreteReading reading = {};  ///< its ε is for DiscreteSolver::Hybrid only
  DiscreteSolver solver = DiscreteSolver::Hybrid;
  /// On the Euclidean norm of the residual: the paper's.
  double tolerance = 1e-6;
};

/// All options of solve(). The defaults are right for almost every scene.
struct SolveOptions {
  /// How the extremal is found, each method with what it can be told.
  std::variant<Collocation, Shooting, DiscreteSystem> method = {};
  Limits limits = {};

  /// The options of a method, nullptr if it is another one.
  template <class Method>
  [[nodiscard]] const Method* of() const {
    return std::get_if<Method>(&method);
  }
  /// The same, or the method's defaults.
  template <class Method>
  [[nodiscard]] Method or_default() const {
    return of<Method>() != nullptr ? *of<Method>() : Method{};
  }
  /// The options of a method, which becomes the one that is used.
  template <class Method>
  [[nodiscard]] Method& use() {
    if (of<Method>() == nullptr) method = Method{};
    return std::get<Method>(method);
  }
  /// Whether all extremals are wanted that can be found.
  [[nodiscard]] bool searches() const {
    const auto* program = of<Collocation>();
    return program != nullptr && program->search == Search::Global;
  }
  /// True if the answer is the end of one branch that is followed.
  [[nodiscard]] bool follows_the_branch() const {
    const auto* program = of<Collocation>();
    return program != nullptr && program->search == Search::Principal &&
           program->guess == Guess::Cycloid;
  }
};

}  // namespace brachisto
