// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/bead_boundary.hpp"

#include <cmath>

#include "brachisto/model/cycloid.hpp"
#include "reproduction/orientation.hpp"
#include "reproduction/transit.hpp"

namespace brachisto::reproduction {

namespace {

/// Secant steps in k; τ² is nearly linear in it, for η_m = 0 exactly.
double equal_time_k(Scene scene, double bead, double k, double largest) {
  constexpr double kClose = 1e-9;
  constexpr int kMostSteps = 12;
  const auto excess = [&](double at) {
    scene.body.k = at;
    const double tau = verified_tau(scene);
    return tau * tau - bead * bead;
  };
  double k_before = largest;
  double before = excess(k_before);
  if (before <= 0.0) return largest;
  for (int step = 0; step < kMostSteps; ++step) {
    const double now = excess(k);
    const double next = k - now * (k - k_before) / (now - before);
    k_before = k;
    before = now;
    k = std::clamp(next, 0.0, largest);
    if (std::abs(k - k_before) < kClose) break;
  }
  return k;
}

}  // namespace

std::vector<BoundaryBody> bead_boundary(const Scene& scene,
                                        const std::vector<double>& eta_m,
                                        bool best) {
  Scene bead_scene = scene;
  bead_scene.body = Body::bead();
  const double bead = verified_tau(bead_scene);
  std::vector<BoundaryBody> boundary;
  double k = 0.1;
  Scene one = scene;
  for (const double eta : eta_m) {
    const double largest = 1.0 - eta * eta;
    one.body.eta_m = eta;
    // By the envelope theorem an error of θ_m matters to k only squared.
    const int rounds = best && eta > 0.0 ? 2 : 1;
    for (int round = 0; round < rounds; ++round) {
      if (rounds > 1) {
        one.body.k = std::min(k, largest);
        one.body.theta_m =
            fastest_orientation(one, one.body.theta_m).theta_m.value;
      }
      k = equal_time_k(one, bead, std::min(k, 0.9 * largest), largest);
    }
    boundary.push_back({eta, k, one.body.theta_m, k >= largest});
  }
  return boundary;
}

}  // namespace brachisto::reproduction
