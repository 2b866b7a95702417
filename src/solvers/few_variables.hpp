// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Problems of a few variables whose second derivatives nobody knows: the last
/// digits of a solution, and of what kind it is.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "nlp/active_set.hpp"

namespace brachisto {

/// A point at which the optimality conditions hold to rounding.
struct FewVariablesPoint {
  PrimalDual point;
  nlp::ActiveSet active;
  /// Eigenvalues, ascending, of the Hessian of the Lagrangian on the directions
  /// along all that is held: all positive at a strict minimum. Empty if nothing
  /// is free.
  std::vector<double> curvatures;
  /// To first order, with multipliers of the sign that bounds ask for.
  bool converged = false;
};

/// Newton's method on the optimality conditions, from the point at which
/// another solver stopped. What is held at a bound there stays there, unless
/// its multiplier turns out to pull it away: then it is let go of. The Hessian
/// comes from central differences of gradients, 2 for each variable that is
/// free, where the same is held at the start alone: errors shrink by its
/// relative error in every step.
///
/// \param problem  with a dense pattern of the Jacobian, row by row
/// \param step     of the differences, in every variable
[[nodiscard]] FewVariablesPoint refine_few_variables(nlp::Problem& problem,
                                                     PrimalDual start,
                                                     double step);

}  // namespace brachisto
