// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Pontryagin's Hamiltonian in the rolling time u.

#pragma once

#include <cmath>

#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

/// Costates of (x, z, θ, w): minus the gradient of the least time with respect
/// to the end state, so that 𝓗 = √A + p·f is minimal and zero on an extremal.
struct Costates {
  double p_x = 0.0, p_z = 0.0, p_theta = 0.0, p_w = 0.0;
};

/// State of the motion at one u apart from x and z, which no rate depends on.
struct RollingState {
  double theta = 0.0;  ///< [rad]
  double w = 0.0;      ///< √(2 g E) [m/s]
};

/// The part of 𝓗 that depends on the slope angle β,
///
///     h(β) = √A(θ, β) + w (p_x cos β + p_z sin β) + p_w g sin β,
///
/// and its first two derivatives. With c = η cos(θ − β)/√A,
/// ∂√A/∂β = c and ∂²√A/∂β² = (η sin(θ − β) − c²)/√A.
struct SlopeHamiltonian {
  double value, d_beta, d2_beta;
};

[[nodiscard]] inline SlopeHamiltonian slope_hamiltonian(
    const Body& body, double gravity, const RollingState& state,
    const Costates& p, double beta) {
  const double root = std::sqrt(inertia_factor(body, state.theta, beta));
  const double c = body.eta_m * std::cos(state.theta - beta) / root;
  const double d2_root =
      (body.eta_m * std::sin(state.theta - beta) - c * c) / root;
  const double pull_x = state.w * p.p_x;
  const double pull_z = state.w * p.p_z + p.p_w * gravity;
  const double along = pull_x * std::cos(beta) + pull_z * std::sin(beta);
  const double across = pull_z * std::cos(beta) - pull_x * std::sin(beta);
  return {root + along, c + across, d2_root - along};
}

/// 𝓗 = h(β) + p_θ w/r + p_w g η cos θ; p_θ counts only for a body that rolls.
[[nodiscard]] inline double hamiltonian(const Body& body, double gravity,
                                        const RollingState& state,
                                        const Costates& p, double beta) {
  double h = slope_hamiltonian(body, gravity, state, p, beta).value +
             p.p_w * gravity * body.eta_m * std::cos(state.theta);
  if (body.rolls()) h += p.p_theta * state.w / body.radius;
  return h;
}

/// By how much 𝓗 falls at most if β is replaced by another direction, over the
/// √A of the former, or 0: Weierstrass's condition wants it so. 64 directions
/// are tried. Minima of h are as wide as the extremes of sine and cosine of
/// single angles make them; two per turn can hardly hide between so many.
[[nodiscard]] double gain_of_other_directions(const Body& body, double gravity,
                                              const RollingState& state,
                                              const Costates& p, double beta);

/// dβ/du along an extremal [rad/s], from ∂𝓗/∂β = 0 differentiated along it:
///
///     h_ββ β' = −h_βθ θ' − h_βw w' − h_βp_w p_w',  h_βθ = −∂²√A/∂β²,
///     p_w' = −∂𝓗/∂w = −(p_x cos β + p_z sin β + p_θ/r).
///
/// Regular at the start, where the curvature κ_c = β'/w is not.
[[nodiscard]] double slope_rate(const Body& body, double gravity,
                                const RollingState& state, const Costates& p,
                                double beta);

/// The slope angle nearest to `near` that makes 𝓗 minimal: ∂𝓗/∂β = 0 with
/// ∂²𝓗/∂β² > 0 [rad]. NaN if no minimum is reached from there.
[[nodiscard]] double minimising_slope(const Body& body, double gravity,
                                      const RollingState& state,
                                      const Costates& p, double near);

}  // namespace brachisto
