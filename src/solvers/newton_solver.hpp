// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method on one problem again and again.

#pragma once

#include <memory>

#include "brachisto/solvers/newton_kkt.hpp"

namespace brachisto {

/// solve_with_newton() for a problem that moves and keeps its patterns, as
/// along a branch: its structure is analysed once, and memory and pivots are
/// kept from solve to solve.
class NewtonSolver {
 public:
  /// \param tangency  may be null; both must outlive this
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
