// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/start_under_limits.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/start_angle.hpp"

namespace brachisto {

std::optional<double> start_angle_under(
    const Scene& scene, const std::vector<PathInequality>& limits) {
  const Body& body = scene.body;
  const auto allowed = [&](double beta) {
    const TurningPoint<double> at = resting_at(scene, beta);
    const ContactForce<double> force = contact_force(scene, at);
    double least = speed_gain(scene, at) / scene.gravity;
    for (const PathInequality& limit : limits) {
      if (!limit.bounds_force()) continue;
      const double value = value_of(limit, force, at);
      least = std::min({least, value - limit.lower, limit.upper - value});
    }
    return least;
  };
  const double free = start_angle(scene);
  const auto growth = [&](double beta) {
    const double a = speed_gain(scene, resting_at(scene, beta));
    const double root = root_of_inertia(scene, body.theta_m, beta);
    return a * a / (root * root);
  };
  constexpr double kRounding = 1e-12;
  if (allowed(free) >= -kRounding) return free;
  std::optional<double> best;
  for (const double direction : {-1.0, 1.0}) {
    constexpr int kSteps = 720;
    double outside = free;
    for (int i = 1; i <= kSteps; ++i) {
      const double inside = free + direction * std::numbers::pi * i / kSteps;
      if (allowed(inside) >= 0.0) {
        double in = inside;
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (in + outside);
          (allowed(middle) >= 0.0 ? in : outside) = middle;
        }
        if (!best || growth(in) > growth(*best)) best = in;
        break;
      }
      outside = inside;
    }
  }
  return best;
}

std::optional<double> known_start_slope(
    const Scene& scene, const std::vector<PathInequality>& limits) {
  if (scene.world.start_speed > 0.0 || scene.contact == Contact::Optimal ||
      bound_valleys(limits)) {
    return std::nullopt;
  }
  return start_angle_under(scene, limits);
}

}  // namespace brachisto
