// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Losses that grow with the load: Coulomb friction of a bead and the
/// resistance of what rolls, for numbers, jets and formulas.
///
/// Both take the power c g R_n v_c per mass, c being μ of a bead and c of what
/// rolls. R_n is affine in how fast the slope turns, and so would be the rate
/// of the kinetic energy ½ w². With an M(θ, β) whose derivative by β is what
/// turning costs, the state
///
///     W = w e^{−M}   on   ds = W du,   v_c = W/√A*,   √A* = √A e^{−M}
///
/// has a rate that turning has no part in: the slope is a control again. All
/// formulas stay what they are without losses, but for √A*, which stands for √A
/// where times and speeds are meant, and for W'.

#pragma once

#include <cmath>

#include "brachisto/model/scene.hpp"
#include "model/inertia.hpp"

namespace brachisto::losses {

// What only scenes with losses call stands out of line: within the loops of
// other scenes it would cost instructions.

/// What a unit of turning costs, of W over itself,
///
///     m = ∂M/∂β = c (q̂² + k)/(A D),   D = A − c η cos δ,   δ = θ − β,
///       = (c − η cos δ)/D + η cos δ/A,
///
/// whose integral over δ is
///
///     m̄ δ + ν ln D + 2 (ρ/Q) arctan(D'/(D + Q)) − ½ ln A,
///     ν = 2/(4 + c²),  ρ = c − c a/(4 + c²),  Q² = a² − η² (4 + c²),
///     a = 1 + η² + k,  m̄ = c/(4 + c²) + ρ/Q,  D' = dD/dδ.
///
/// M = m̄ β less the periodic rest stays small however often the body turns.
struct Turning {
  double nu, rho, Q, mean;

  /// \pre bounded() for the same numbers
  Turning(const Body& body, double c) {
    const double eta = body.eta_m;
    const double n = 4.0 + c * c;
    const double a = 1.0 + eta * eta + body.k;
    nu = 2.0 / n;
    rho = c - c * a / n;
    Q = std::sqrt(a * a - eta * eta * n);
    mean = c / n + rho / Q;
  }
};

/// Whether D > 0 at every angle. Where it vanishes the load has no bound.
[[nodiscard]] inline bool bounded(const Body& body, double c) {
  const double eta = body.eta_m;
  return 1.0 + eta * eta + body.k > eta * std::sqrt(4.0 + c * c);
}

/// √A*: with an offset D^ν e^{2 (ρ/Q) arctan(D'/(D + Q)) − m̄ β}, otherwise
/// √(1 + k) e^{−c β/(1 + k)}.
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar root_of_inertia(
    const Body& body, double c, const Scalar& theta, const Scalar& beta) {
  using std::atan;
  using std::cos;
  using std::exp;
  using std::log;
  using std::sin;
  if (!body.off_centred()) {
    const double A = axisymmetric_inertia_factor(body);
    return exp(beta * (-c / A)) * std::sqrt(A);
  }
  const Turning turning(body, c);
  const Scalar delta = theta - beta;
  const Scalar sine = sin(delta) * body.eta_m;
  const Scalar cosine = cos(delta) * body.eta_m;
  const Scalar D = inertia_factor(body, theta, beta) - cosine * c;
  const Scalar slope = sine * c - cosine * 2.0;
  return exp(log(D) * turning.nu +
             atan(slope / (D + Scalar(turning.Q))) *
                 (2.0 * turning.rho / turning.Q) -
             beta * turning.mean);
}

/// R_n and what it takes, of R_n⁰ without losses: the body that is braked
/// swings its centre of mass less, so that R_n = R_n⁰ A/D.
template <class Scalar>
[[nodiscard]] Scalar load(const Body& body, double c, const Scalar& theta,
                          const Scalar& beta, const Scalar& without) {
  using std::cos;
  if (!body.off_centred()) return without;
  const Scalar A = inertia_factor(body, theta, beta);
  return without * A / (A - cos(theta - beta) * (body.eta_m * c));
}

/// W' = (A*/A) (w' − c g R_n) + (m − m̄) W²/r, R_n where the slope does not
/// turn.
///
/// \param W         the state
/// \param root      √A*
/// \param gain      w' from the field and the air
/// \param pressing  g R_n of a body at rest without an offset
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar speed_gain(
    const Body& body, double c, const Scalar& theta, const Scalar& beta,
    const Scalar& W, const Scalar& root, const Scalar& gain,
    const Scalar& pressing) {
  using std::cos;
  using std::sin;
  if (!body.off_centred()) {
    const double A = axisymmetric_inertia_factor(body);
    return root * root * (gain - pressing * c) * (1.0 / A);
  }
  const double per_r = 1.0 / body.radius;
  const Scalar delta = theta - beta;
  const Scalar eta_sin = sin(delta) * body.eta_m;
  const Scalar eta_cos = cos(delta) * body.eta_m;
  const Scalar A = inertia_factor(body, theta, beta);
  const Scalar D = A - eta_cos * c;
  const Scalar v = W / root;
  const Scalar spin = v * v * per_r;
  const Scalar v_dot = (gain + spin * eta_cos) / A;
  const Scalar R = (pressing - eta_cos * v_dot + eta_sin * spin) * A / D;
  const Scalar turning =
      (A - eta_cos * eta_cos) / (A * D) * c - Scalar(Turning(body, c).mean);
  return root * root / A * (gain - R * c) + turning * W * W * per_r;
}

}  // namespace brachisto::losses
