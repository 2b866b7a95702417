// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far a point is from satisfying the first-order conditions of a problem,
/// computed from its public functions alone.

#pragma once

#include <span>
#include <string>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

/// Residual of the Karush–Kuhn–Tucker conditions.
struct KktResidual {
  double stationarity = 0.0;  ///< max |∂(f + λᵀg)/∂x_i| over free variables
  double infeasibility = 0.0;    ///< max |g_i|
  double bound_violation = 0.0;  ///< max distance of a fixed variable from its
                                 ///< value
  std::string worst_variable;    ///< where the stationarity is worst
  std::string worst_constraint;  ///< where the infeasibility is worst

  [[nodiscard]] double max() const;
};

/// Residual at (x, λ). The problem is moved to x.
///
/// \throws std::domain_error if the problem is not evaluable at x
[[nodiscard]] KktResidual kkt_residual(Problem& problem,
                                       std::span<const double> x,
                                       std::span<const double> lambda);

}  // namespace brachisto::nlp
