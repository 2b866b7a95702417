// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The optimality conditions once more, by other means.

#pragma once

#include <string>

#include "brachisto/nlp/problem.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// Residuals of a problem at (x, λ).
struct ExtendedResidual {
  double stationarity = 0.0;  ///< max |∂(f + λᵀg)/∂x_i| over free variables
  double defects = 0.0;       ///< max |g_i|
  double fixed_values = 0.0;  ///< max distance of a fixed variable from its
                              ///< value
  std::string worst_variable, worst_constraint;
};

/// Recomputes the residual in long double. The derivatives come from jets
/// through the functions of the model; of the problem's own code only the
/// layout, the mesh and its matrices are used, and none of the
/// closed forms that the optimiser worked with.
[[nodiscard]] ExtendedResidual extended_residual(const RollingTime& problem,
                                                 const PrimalDual& point);
[[nodiscard]] ExtendedResidual extended_residual(const ArcLength& problem,
                                                 const PrimalDual& point);

}  // namespace brachisto
