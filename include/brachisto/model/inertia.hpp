// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The inertia factor A(θ, β): how much kinetic energy a rolling body carries
/// for a given speed of its centre.

#pragma once

#include <cmath>

#include "brachisto/model/body.hpp"

namespace brachisto {

/// Inertia factor A = 1 + η² + k − 2 η sin(θ − β), so that v_c² = 2 g E / A
/// (eqs. (7) and (B2)).
///
/// Evaluated as (1 − η)² + k + 2 η (cos δ/2 − sin δ/2)², δ = θ − β, the same by
/// 1 − sin δ = (cos δ/2 − sin δ/2)²: a sum of terms that are never negative.
/// The difference in the square does cancel near δ = π/2, but its rounding
/// error ε enters A only as 4 η |cos − sin| ε, which vanishes there too.
///
/// \tparam Scalar  double, long double, or a jet of either
template <class Scalar>
[[nodiscard]] Scalar inertia_factor(const Body& body, const Scalar& theta,
                                    const Scalar& beta) {
  using std::cos;
  using std::sin;
  const double eta = body.eta_m;
  const Scalar half = (theta - beta) * 0.5;
  const Scalar d = cos(half) - sin(half);
  return d * d * (2.0 * eta) + ((1.0 - eta) * (1.0 - eta) + body.k);
}

/// The same from sin δ, as eq. (7) prints it, for where sines and cosines of θ
/// are at hand: cheaper, and as accurate unless A is small.
template <class Scalar>
[[nodiscard]] Scalar inertia_factor(const Body& body, const Scalar& sin_delta) {
  const double eta = body.eta_m;
  return sin_delta * (-2.0 * eta) + (1.0 + eta * eta + body.k);
}

/// Inertia factor of a body whose centre of mass lies on its axis: 1 + k.
[[nodiscard]] inline double axisymmetric_inertia_factor(const Body& body) {
  return 1.0 + body.k;
}

}  // namespace brachisto
