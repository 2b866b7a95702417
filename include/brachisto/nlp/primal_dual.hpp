// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A point in the space of unknowns and multipliers.

#pragma once

#include <vector>

namespace brachisto {

/// Values of the unknowns and multipliers. The signs are Ipopt's: with the
/// Lagrangian
///
///     f + λᵀg − z_lᵀ(x − x_l) − z_uᵀ(x_u − x)
///
/// z_l, z_u ≥ 0 at a minimum, λ_i ≥ 0 where g_i is at its upper bound, λ_i ≤ 0
/// where it is at its lower one, and λ_i = 0 between. Derivatives of the least
/// f are z_l by x_l, −z_u by x_u, and −λ by a bound of g that holds.
struct PrimalDual {
  std::vector<double> x;       ///< num_variables() values
  std::vector<double> lambda;  ///< num_constraints() values; empty: unknown
  /// num_variables() values each; zero for fixed variables. Empty: zero, as for
  /// problems without inequalities, or unknown.
  std::vector<double> z_lower = {}, z_upper = {};
};

}  // namespace brachisto
