// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The matrices of collocation on the unit element, at Gauss's points and at
/// Radau's.

#pragma once

#include "math/gauss.hpp"
#include "math/polynomial_basis.hpp"

namespace brachisto {

/// Collocation of degree p on the element [0, 1]: a polynomial of degree p is
/// given by its values at the p + 1 Gauss–Lobatto points (its nodes, both ends
/// among them) and satisfies the differential equation at the p Gauss points.
///
/// As a Runge–Kutta method this is Gauss's, of order 2p at the element ends.
struct CollocationScheme {
  explicit CollocationScheme(int degree);

  int degree;
  math::LagrangeBasis nodes;        ///< through the p + 1 nodes
  math::LagrangeBasis points;       ///< through the p collocation points
  math::QuadratureRule rule;        ///< the p Gauss points and weights b
  math::SmallMatrix interpolation;  ///< p × (p + 1): nodes → values at points
  math::SmallMatrix derivative;  ///< p × (p + 1): nodes → slopes at points
  math::SmallMatrix integral;    ///< (p + 1) × p: rates at points → integral
                                 ///< from 0 to each node
};

/// Radau IIA collocation of degree p on [0, 1]: a polynomial of degree p is
/// given by its values at 0 and at the p Radau points, where it satisfies the
/// differential equation; the last of them is 1.
struct RadauScheme {
  explicit RadauScheme(int degree);

  int degree;
  math::QuadratureRule rule;     ///< the p Radau points and weights
  math::LagrangeBasis nodes;     ///< through 0 and the points
  math::LagrangeBasis points;    ///< through the points alone
  math::SmallMatrix derivative;  ///< p × (p + 1): nodes → slopes at points
};

/// The largest degree of a scheme: that of problems, and one more to check it.
inline constexpr int kLargestDegree = 12;

/// The scheme of a degree, 1 … kLargestDegree, built once per process.
[[nodiscard]] const CollocationScheme& collocation_scheme(int degree);
[[nodiscard]] const RadauScheme& radau_scheme(int degree);

}  // namespace brachisto
