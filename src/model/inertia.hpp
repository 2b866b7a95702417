// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The inertia factor A(θ, β): how much kinetic energy a rolling body carries
/// for a given speed of its centre.

#pragma once

#include <cmath>

#include "brachisto/model/body.hpp"
#include "math/constant_of.hpp"
#include "math/interval.hpp"

namespace brachisto {

/// Inertia factor A = 1 + η² + k − 2 η sin(θ − β), so that v_c² = 2 g E / A
/// (eqs. (7) and (B2)).
///
/// Evaluated as (1 − η)² + k + 2 η (cos δ/2 − sin δ/2)², δ = θ − β, the same by
/// 1 − sin δ = (cos δ/2 − sin δ/2)²: a sum of terms that are never negative.
/// The difference in the square does cancel near δ = π/2, but its rounding
/// error ε enters A only as 4 η |cos − sin| ε, which vanishes there too.
///
/// \tparam AnyBody  Body, or the numbers of several bodies side by side
/// \tparam Scalar   double, long double, a jet of either, or lanes
template <class AnyBody, class Scalar>
[[nodiscard]] Scalar inertia_factor(const AnyBody& body, const Scalar& theta,
                                    const Scalar& beta) {
  using std::cos;
  using std::sin;
  const math::ConstantOf<Scalar> eta(body.eta_m);
  const Scalar half = (theta - beta) * 0.5;
  const Scalar d = cos(half) - sin(half);
  return d * d * (2.0 * eta) + ((1.0 - eta) * (1.0 - eta) + body.k);
}

/// The same over a range of places, in which δ occurs once: it is enclosed as
/// closely as can be, and as 1 − sin δ ≥ 0 never by a range with 0 in it.
[[nodiscard]] inline math::Interval inertia_factor(const Body& body,
                                                   const math::Interval& theta,
                                                   const math::Interval& beta) {
  const double eta = body.eta_m;
  return (1.0 - sin(theta - beta)) * (2.0 * eta) +
         ((1.0 - eta) * (1.0 - eta) + body.k);
}

/// The same from sin δ, as eq. (7) prints it, for where sines and cosines of θ
/// are at hand: cheaper, and as accurate unless A is small.
template <class Scalar>
[[nodiscard]] Scalar inertia_factor(const Body& body, const Scalar& sin_delta) {
  const double eta = body.eta_m;
  return sin_delta * (-2.0 * eta) + (1.0 + eta * eta + body.k);
}

/// Inertia factor of a body whose centre of mass lies on its axis: 1 + k.
template <class Number = double>
[[nodiscard]] Number axisymmetric_inertia_factor(const Body& body) {
  return Number(1.0) + body.k;
}

/// Kinetic energy as a height, that is in units of m g [m].
struct KineticEnergy {
  double translation = 0.0;  ///< ½ m v_cm², of the centre of mass
  double rotation = 0.0;     ///< ½ I_cm ω²

  [[nodiscard]] double total() const { return translation + rotation; }
};

/// Of a body whose centre moves at v_c. With v_cm² = (A − k) v_c² and
/// I_cm ω² = k m v_c² the total is A v_c² / 2g = E, the energy height.
[[nodiscard]] inline KineticEnergy kinetic_energy(const Body& body,
                                                  double gravity, double theta,
                                                  double beta, double v_c) {
  const double height = 0.5 * v_c * v_c / gravity;
  const double A = inertia_factor(body, theta, beta);
  return {(A - body.k) * height, body.k * height};
}

}  // namespace brachisto
