// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Matrices such as other people's Ipopt has them.

#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "support/random_points.hpp"

namespace brachisto::testing {

/// Of a discretised control problem with a parameter that everything depends
/// on, its unknowns in any order:
///
///     x_k+1 = A_k x_k + B_k u_k + c_k p,  k = 0 … steps − 1,
///
/// quadratic costs of x and u that may be negative, x_0 given.
inline Eigen::MatrixXd kkt_matrix(int steps, int states, int controls,
                                  Random& random) {
  const int node = states + controls;
  const int n = steps * node + 1, size = n + steps * states;
  const int p = n - 1;
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  const auto put = [&](int i, int j, double value) {
    K(i, j) = K(j, i) = value;
  };
  put(p, p, 5.0);
  for (int k = 0; k < steps; ++k) {
    const int u = k * node, x = u + controls;  // x_k+1
    for (int i = u; i < u + node; ++i) {
      for (int j = u; j <= i; ++j) put(i, j, random.uniform(-0.3, 0.3));
      put(i, i, random.uniform(-0.2, 2.0));
    }
    for (int row = n + k * states, s = 0; s < states; ++s, ++row) {
      put(row, x + s, 1.0);
      put(row, p, random.uniform(-1.0, 1.0));
      for (int i = 0; i < controls; ++i) {
        put(row, u + i, random.uniform(-1.0, 1.0));
      }
      for (int i = 0; i < states && k > 0; ++i) {
        put(row, x - node + i, random.uniform(-0.5, 0.5));
      }
    }
  }
  std::vector<int> order(static_cast<std::size_t>(size));
  std::iota(order.begin(), order.end(), 0);
  for (int i = size; i-- > 1;) {
    std::swap(order[static_cast<std::size_t>(i)],
              order[static_cast<std::size_t>(random.uniform(0.0, i + 1.0))]);
  }
  Eigen::MatrixXd mixed(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      mixed(i, j) = K(order[static_cast<std::size_t>(i)],
                      order[static_cast<std::size_t>(j)]);
    }
  }
  return mixed;
}

}  // namespace brachisto::testing
