// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a solver returns.

#pragma once

#include <string>

#include "brachisto/nlp/primal_dual.hpp"
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

}  // namespace brachisto
