// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/world_hamiltonian.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "math/nearest_minimum.hpp"

namespace brachisto {

namespace {

double inverse_radius(const Body& body) {
  return body.rolls() ? 1.0 / body.radius : 0.0;
}

/// In an ordinary world no rate depends on the place.
RollingState rolling_part(const MovingState& state) {
  return {state.theta, state.w};
}

PhasePoint<double> phase_of(const MovingState& state, const Costates& p,
                            double beta) {
  return {state.centre.x, state.centre.z, state.theta, state.w, p.p_x,
          p.p_z,          p.p_theta,      p.p_w,       beta};
}

/// 𝓗 and its derivatives by β alone.
SlopeHamiltonian by_slope(const Scene& scene, const PhasePoint<double>& at) {
  using Jet = math::Jet2<double, 1>;
  const Jet h =
      hamiltonian_of<Jet>(scene, inverse_radius(scene.body),
                          {at.x, at.z, at.theta, at.w, at.p_x, at.p_z,
                           at.p_theta, at.p_w, Jet::variable(at.beta, 0)});
  return {h.value, h.gradient[0], h.hessian[0]};
}

}  // namespace

PhaseJet hamiltonian_jet(const Scene& scene, double inverse_radius,
                         const PhasePoint<double>& at) {
  const auto variable = [](double value, int index) {
    return PhaseJet::variable(value, index);
  };
  return hamiltonian_of<PhaseJet>(
      scene, inverse_radius,
      {variable(at.x, 0), variable(at.z, 1), variable(at.theta, 2),
       variable(at.w, 3), variable(at.p_x, 4), variable(at.p_z, 5),
       variable(at.p_theta, 6), variable(at.p_w, 7), variable(at.beta, 8)});
}

SlopeHamiltonian slope_hamiltonian(const Scene& scene, const MovingState& state,
                                   const Costates& p, double beta) {
  if (!scene.world.changes_rates()) {
    return slope_hamiltonian(scene.body, scene.gravity, rolling_part(state), p,
                             beta);
  }
  return by_slope(scene, phase_of(state, p, beta));
}

double hamiltonian(const Scene& scene, const MovingState& state,
                   const Costates& p, double beta) {
  if (!scene.world.changes_rates()) {
    return hamiltonian(scene.body, scene.gravity, rolling_part(state), p, beta);
  }
  return hamiltonian_of(scene, inverse_radius(scene.body),
                        phase_of(state, p, beta));
}

double gain_of_other_directions(const Scene& scene, const MovingState& state,
                                const Costates& p, double beta) {
  if (!scene.world.changes_rates()) {
    return gain_of_other_directions(scene.body, scene.gravity,
                                    rolling_part(state), p, beta);
  }
  constexpr int kDirections = 64;
  const double own = hamiltonian(scene, state, p, beta);
  double gain = 0.0;
  for (int i = 0; i < kDirections && !std::isnan(gain); ++i) {
    const double other = 2.0 * std::numbers::pi * i / kDirections;
    const double better = own - hamiltonian(scene, state, p, other);
    // Written so that a NaN stays.
    gain = better <= gain ? gain : better;
  }
  return gain / root_of_inertia(scene, state.theta, beta);
}

double slope_rate_along(const Scene& scene, const MovingState& state,
                        const Costates& p, double beta,
                        const std::array<double, 8>& rates) {
  const PhaseJet h = hamiltonian_jet(scene, inverse_radius(scene.body),
                                     phase_of(state, p, beta));
  double change = 0.0;
  for (int i = 0; i < static_cast<int>(kPhaseBeta); ++i) {
    change += h.hessian[PhaseJet::pair(kPhaseBeta, i)] *
              rates[static_cast<std::size_t>(i)];
  }
  return -change / h.hessian[PhaseJet::pair(kPhaseBeta, kPhaseBeta)];
}

double slope_rate(const Scene& scene, const MovingState& state,
                  const Costates& p, double beta) {
  if (!scene.world.changes_rates()) {
    return slope_rate(scene.body, scene.gravity, rolling_part(state), p, beta);
  }
  const PhaseJet h = hamiltonian_jet(scene, inverse_radius(scene.body),
                                     phase_of(state, p, beta));
  // Hamilton's equations.
  const auto& d = h.gradient;
  return slope_rate_along(scene, state, p, beta,
                          {d[4], d[5], d[6], d[7], -d[0], -d[1], -d[2], -d[3]});
}

double minimising_slope(const Scene& scene, const MovingState& state,
                        const Costates& p, double near) {
  if (!scene.world.changes_rates()) {
    return minimising_slope(scene.body, scene.gravity, rolling_part(state), p,
                            near);
  }
  return math::nearest_minimum(
      [&](double beta) { return by_slope(scene, phase_of(state, p, beta)); },
      near);
}

}  // namespace brachisto
