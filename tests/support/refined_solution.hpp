// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Solutions by a chain factorisation that are exact but for their rounding.

#pragma once

#include <vector>

#include "solvers/chain_ldlt.hpp"

namespace brachisto::testing {

/// Solves A x = b with steps of refinement, residuals in long double.
[[nodiscard]] inline std::vector<double> refined_solution(
    const ChainLdlt& ldlt, const std::vector<double>& b, int refinements) {
  std::vector<double> x = b;
  ldlt.solve(x);
  for (int step = 0; step < refinements; ++step) {
    std::vector<double> correction = b;
    ldlt.subtract_product(x, correction);
    ldlt.solve(correction);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
  }
  return x;
}

}  // namespace brachisto::testing
