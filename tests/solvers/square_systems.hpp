// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Square systems whose solution is known.

#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace brachisto::testing {

/// Broyden's tridiagonal function with nine unknowns, the example in MINPACK's
/// user guide, which also prints the start and the solution:
///
///     F_i = (3 − 2 x_i) x_i − x_{i−1} − 2 x_{i+1} + 1,  x_0 = x_10 = 0.
inline bool broyden_tridiagonal(std::span<const double> x,
                                std::span<double> F) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double before = i > 0 ? x[i - 1] : 0.0;
    const double after = i + 1 < x.size() ? x[i + 1] : 0.0;
    F[i] = (3.0 - 2.0 * x[i]) * x[i] - before - 2.0 * after + 1.0;
  }
  return true;
}

inline constexpr std::array kBroydenSolution{
    -0.5706545, -0.6816283, -0.7017325, -0.7042129, -0.7013690,
    -0.6918656, -0.6657920, -0.5960342, -0.4164121};
/// Seven digits are printed.
inline constexpr double kBroydenPrinted = 5e-8;

[[nodiscard]] inline std::vector<double> broyden_start() {
  return std::vector<double>(kBroydenSolution.size(), -1.0);
}

/// ln x = 0, not defined for x ≤ 0; from x = 10 Newton's step leads to −13.
inline bool logarithm(std::span<const double> x, std::span<double> F) {
  if (!(x[0] > 0.0)) return false;
  F[0] = std::log(x[0]);
  return true;
}

/// x² + 1 = 0: no real root.
inline bool rootless(std::span<const double> x, std::span<double> F) {
  F[0] = x[0] * x[0] + 1.0;
  return true;
}

}  // namespace brachisto::testing
