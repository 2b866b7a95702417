// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The mesh: how σ ∈ [0, 1] is cut into elements.

#pragma once

#include <vector>

namespace brachisto {

/// Elements with polynomials of one degree.
struct Mesh {
  int degree = 1;                  ///< p ≥ 1
  std::vector<double> boundaries;  ///< N + 1 values, 0 = first < … < last = 1

  [[nodiscard]] int num_elements() const {
    return static_cast<int>(boundaries.size()) - 1;
  }
  /// N p, the number of collocation points.
  [[nodiscard]] int num_points() const { return num_elements() * degree; }
  /// N p + 1, the number of nodes, element ends counted once.
  [[nodiscard]] int num_nodes() const { return num_points() + 1; }
  /// h_e, the length of element e.
  [[nodiscard]] double length(int element) const {
    const auto e = static_cast<std::size_t>(element);
    return boundaries[e + 1] - boundaries[e];
  }
};

/// N elements of equal length.
[[nodiscard]] Mesh uniform_mesh(int degree, int num_elements);

}  // namespace brachisto
