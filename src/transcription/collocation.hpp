// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The matrices of Gauss–Legendre collocation on the unit element.

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

/// The largest degree of a scheme: that of problems, and one more to check it.
inline constexpr int kLargestDegree = 12;

/// The scheme of a degree, 1 … kLargestDegree, built once per process.
[[nodiscard]] const CollocationScheme& collocation_scheme(int degree);

}  // namespace brachisto
