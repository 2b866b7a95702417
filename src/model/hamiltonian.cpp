// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/hamiltonian.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "math/nearest_minimum.hpp"

namespace brachisto {

namespace {

constexpr int kDirections = 64;
using PerDirection = std::array<double, kDirections>;

/// Sines and cosines of a full turn in equal steps.
struct Directions {
  PerDirection cosine, sine;

  Directions() {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double beta =
          2.0 * std::numbers::pi * static_cast<double>(i) / kDirections;
      cosine[i] = std::cos(beta);
      sine[i] = std::sin(beta);
    }
  }
};

}  // namespace

double gain_of_other_directions(const Body& body, double gravity,
                                const RollingState& state, const Costates& p,
                                double beta) {
  static const Directions directions;
  const double own_root = std::sqrt(inertia_factor(body, state.theta, beta));
  const double pull_x = state.w * p.p_x;
  const double pull_z = state.w * p.p_z + p.p_w * gravity;
  const double own =
      own_root + pull_x * std::cos(beta) + pull_z * std::sin(beta);
  // sin(θ − β) = sin θ cos β − cos θ sin β
  const double sin_theta = std::sin(state.theta);
  const double cos_theta = std::cos(state.theta);
  PerDirection h;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double cosine = directions.cosine[i];
    const double sine = directions.sine[i];
    const double A =
        inertia_factor(body, sin_theta * cosine - cos_theta * sine);
    h[i] = std::sqrt(A) + pull_x * cosine + pull_z * sine;
  }
  // The least of all by as many as a processor compares at once. A NaN passes
  // by comparisons and stays in a sum.
  constexpr std::size_t kAtOnce = 8;
  std::array<double, kAtOnce> least{}, sum{};
  for (std::size_t i = 0; i < kDirections; i += kAtOnce) {
    for (std::size_t k = 0; k < kAtOnce; ++k) {
      const double change = h[i + k] - own;
      least[k] = change < least[k] ? change : least[k];
      sum[k] += change;
    }
  }
  double gain = 0.0, all = 0.0;
  for (std::size_t k = 0; k < kAtOnce; ++k) {
    gain = std::max(gain, -least[k]);
    all += sum[k];
  }
  if (std::isnan(all)) return all;
  return gain / own_root;
}

double slope_rate(const Body& body, double gravity, const RollingState& state,
                  const Costates& p, double beta) {
  const double along = p.p_x * std::cos(beta) + p.p_z * std::sin(beta);
  const double across = p.p_z * std::cos(beta) - p.p_x * std::sin(beta);
  const SlopeHamiltonian h = slope_hamiltonian(body, gravity, state, p, beta);
  const double pull = state.w * along + p.p_w * gravity * std::sin(beta);
  const double d2_root = h.d2_beta + pull;
  const double w_rate = gravity * energy_slope(body, state.theta, beta);
  double p_w_rate = -along;
  double theta_rate = 0.0;
  if (body.rolls()) {
    p_w_rate -= p.p_theta / body.radius;
    theta_rate = state.w / body.radius;
  }
  return (d2_root * theta_rate - across * w_rate -
          gravity * std::cos(beta) * p_w_rate) /
         h.d2_beta;
}

double minimising_slope(const Body& body, double gravity,
                        const RollingState& state, const Costates& p,
                        double near) {
  return math::nearest_minimum(
      [&](double beta) {
        return slope_hamiltonian(body, gravity, state, p, beta);
      },
      near);
}

}  // namespace brachisto
