// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method on the optimality conditions together with a tangency
/// condition, on one problem again and again.

#pragma once

#include <memory>

#include "brachisto/solvers/program_solvers.hpp"

namespace brachisto {

namespace nlp {
class TangencyCondition;
}

/// solve_with_newton() for the unknowns (x, λ, φ), on its equations with
/// x_i = value_i(φ) where x_i is fixed, and F(x, λ, φ) = 0; for a problem that
/// moves and keeps its patterns, as along a branch: its structure is analysed
/// once, and memory and pivots are kept from solve to solve.
class NewtonSolver {
 public:
  /// \param tangency  F; may be null: then there is no φ; both must outlive
  /// this
  NewtonSolver(nlp::Problem& problem, nlp::TangencyCondition* tangency);
  ~NewtonSolver();

  [[nodiscard]] NewtonResult solve(PrimalDual start, double phi,
                                   const NewtonOptions& options);

 private:
  class StepSolver;
  struct Structure;

  void iterate(const NewtonOptions& options, NewtonResult& result);

  nlp::Problem& problem_;
  nlp::TangencyCondition* tangency_;
  std::unique_ptr<Structure> structure_;  ///< of the last active set
};

}  // namespace brachisto
