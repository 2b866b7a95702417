// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The matrices of collocation on the unit element, at Gauss's points and at
/// Radau's.

#pragma once

#include <vector>

#include "brachisto/math/gauss.hpp"
#include "brachisto/math/polynomial_basis.hpp"

namespace brachisto {

/// Collocation of degree p on the element [0, 1]: a polynomial of degree p is
/// given by its values at p + 1 nodes, both ends among them, and satisfies the
/// differential equation at p points.
///
/// As Runge–Kutta methods: Gauss's, of order 2p at the element ends, with the
/// Gauss–Lobatto points for nodes; and Radau's IIA, of order 2p − 1, whose
/// nodes are 0 and its points, the last of which is 1.
struct CollocationScheme {
  int degree;
  bool points_are_nodes;            ///< point j is node j + 1
  math::QuadratureRule rule;        ///< the p points and weights b
  math::LagrangeBasis nodes;        ///< through the p + 1 nodes
  math::LagrangeBasis points;       ///< through the p points
  math::SmallMatrix interpolation;  ///< p × (p + 1): nodes → values at points
  math::SmallMatrix derivative;  ///< p × (p + 1): nodes → slopes at points
  math::SmallMatrix integral;    ///< (p + 1) × p: rates at points → integral
                                 ///< from 0 to each node

  CollocationScheme(math::QuadratureRule points, std::vector<double> nodes);
};

/// The largest degree of a scheme: that of problems, and one more to check it.
inline constexpr int kLargestDegree = 12;

/// The scheme of a degree, 1 … kLargestDegree, built once per process.
[[nodiscard]] const CollocationScheme& gauss_scheme(int degree);
[[nodiscard]] const CollocationScheme& radau_scheme(int degree);

}  // namespace brachisto
