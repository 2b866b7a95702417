// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Gauss–Legendre, Gauss–Lobatto and Radau rules on [0, 1].

#pragma once

#include <vector>

namespace brachisto::math {

/// A quadrature rule on [0, 1].
struct QuadratureRule {
  std::vector<double> points;   ///< ascending
  std::vector<double> weights;  ///< sum to 1
};

/// Gauss–Legendre rule with `count` ≥ 1 points, exact for degree 2·count − 1.
/// Points and weights are right to the last bit or so: they are computed in
/// long double and rounded once.
[[nodiscard]] QuadratureRule gauss_legendre(int count);

/// The `count` ≥ 2 Gauss–Lobatto points on [0, 1], both ends among them: well
/// conditioned nodes for interpolation that neighbouring elements can share.
[[nodiscard]] std::vector<double> gauss_lobatto_points(int count);

/// Radau's rule with `count` ≥ 1 points, the last of them 1, exact for degree
/// 2·count − 2.
[[nodiscard]] QuadratureRule radau_right(int count);

}  // namespace brachisto::math
