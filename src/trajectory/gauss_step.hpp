// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The Gauss rule by whose points motions on given paths advance.

#pragma once

#include "brachisto/math/polynomial_basis.hpp"

namespace brachisto::gauss_step {

inline constexpr int kPoints = 12;

/// On [0, 1].
[[nodiscard]] inline const math::QuadratureRule& rule() {
  static const math::QuadratureRule gauss = math::gauss_legendre(kPoints);
  return gauss;
}

/// Row i integrates a polynomial given at the points, from 0 to point i.
[[nodiscard]] inline const math::SmallMatrix& integration_to_points() {
  static const math::SmallMatrix matrix =
      math::LagrangeBasis(rule().points).integrals_to(rule().points, rule());
  return matrix;
}

}  // namespace brachisto::gauss_step
