// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Speeds at the points of a rule where what brakes depends on the speed.

#pragma once

#include <Eigen/LU>
#include <optional>
#include <tuple>

namespace brachisto {

template <int points>
struct BrakedSpeeds {
  Eigen::Vector<double, points> w;
  Eigen::Vector<double, points> rate;  ///< f at them, to first order
};

/// Solves
///
///     ½ w_i² = k_i + Σ_j a_ij f_j(w_j)
///
/// by Newton's method, which comes down from above, for the equations are
/// convex in w where f falls with it.
///
/// \param w          first guess, the speeds without what brakes
/// \param a          a(i, j)
/// \param f          f(j, w) → value and derivative
/// \param converged  relative change of w; the next step squares it
/// \return nothing where the body is stopped
template <int points, class Matrix, class Rate>
[[nodiscard]] std::optional<BrakedSpeeds<points>> braked_speeds(
    Eigen::Vector<double, points> w, const Eigen::Vector<double, points>& k,
    const Matrix& a, const Rate& f, double converged) {
  constexpr int kMostSteps = 60;
  Eigen::Vector<double, points> rate, by_w, miss;
  Eigen::Matrix<double, points, points> matrix;
  for (int step = 0; step < kMostSteps && w.allFinite(); ++step) {
    for (int i = 0; i < points; ++i) std::tie(rate[i], by_w[i]) = f(i, w[i]);
    for (int i = 0; i < points; ++i) {
      miss[i] = k[i] - 0.5 * w[i] * w[i];
      for (int j = 0; j < points; ++j) {
        miss[i] += a(i, j) * rate[j];
        matrix(i, j) = -a(i, j) * by_w[j];
      }
      matrix(i, i) += w[i];
    }
    const Eigen::Vector<double, points> by = matrix.partialPivLu().solve(miss);
    const double change = (by.array() / w.array()).abs().maxCoeff();
    w = (w + by).cwiseMax(0.1 * w).eval();
    if (change <= converged) {
      return BrakedSpeeds<points>{w, rate + by_w.cwiseProduct(by)};
    }
  }
  return std::nullopt;
}

}  // namespace brachisto
