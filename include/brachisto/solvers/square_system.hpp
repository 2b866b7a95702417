// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Square systems F(x) = 0 and what their solvers have in common.

#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
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

}  // namespace brachisto
