// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far a point is from satisfying the first-order conditions of a problem,
/// computed from its public functions alone.

#pragma once

#include <string>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

/// Residual of the Karush–Kuhn–Tucker conditions. Stationarity and multipliers
/// are divided by Problem::weights(), so that one tolerance means the same on
/// every mesh; distances from bounds are in the units of the problem.
struct KktResidual {
  /// max |∂(f + λᵀg)/∂x_i − z_l,i + z_u,i| over variables that are not fixed
  double stationarity = 0.0;
  double infeasibility = 0.0;    ///< max distance of g_i from its range
  double bound_violation = 0.0;  ///< max distance of a variable from its range
  /// max |multiplier · distance from the bound it belongs to|
  double complementarity = 0.0;
  /// How far a multiplier is on the wrong side of zero, or from zero where
  /// there is no bound it could belong to.
  double sign = 0.0;
  std::string worst_variable;    ///< where the stationarity is worst
  std::string worst_constraint;  ///< where the infeasibility is worst
  std::string worst_multiplier;  ///< where the complementarity is worst
  /// Mean of multiplier · distance over all bounds, not weighted: the barrier
  /// parameter of an interior-point method next to whose path the point is.
  double barrier_parameter = 0.0;

  [[nodiscard]] double max() const;
};

/// Residual at a point. The problem is moved to it.
///
/// \param weights  in place of the problem's, n + m; empty if all are 1
/// \throws std::domain_error if the problem is not evaluable there
[[nodiscard]] KktResidual kkt_residual(Problem& problem,
                                       const PrimalDual& point,
                                       std::span<const double> weights);
[[nodiscard]] inline KktResidual kkt_residual(Problem& problem,
                                              const PrimalDual& point) {
  return kkt_residual(problem, point, problem.weights());
}

/// ∂(f + λᵀg)/∂x at the point the problem was moved to, summed in long double.
[[nodiscard]] std::vector<long double> lagrangian_gradient(
    const Problem& problem, const std::vector<double>& lambda);

}  // namespace brachisto::nlp
