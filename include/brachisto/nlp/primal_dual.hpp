// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A point in the space of unknowns and multipliers.

#pragma once

#include <vector>

namespace brachisto {

/// Values of the unknowns and the multipliers of the equality constraints.
struct PrimalDual {
  std::vector<double> x;       ///< num_variables() values
  std::vector<double> lambda;  ///< num_constraints() values; empty: unknown
};

}  // namespace brachisto
