// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

/// R_n = F/A at rest, and 0 if that is rounding.
double force_at_rest(const Body& body, double beta_0) {
  constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
  const double A = inertia_factor(body, body.theta_m, beta_0);
  const double a = energy_slope(body, body.theta_m, beta_0);
  const double F =
      A * std::cos(beta_0) - a * body.eta_m * std::cos(body.theta_m - beta_0);
  return std::abs(F) <= kRounding * (A + a) ? 0.0 : F / A;
}

}  // namespace

StartLimits start_limits(const Body& body, double beta_0, double beta_rate) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  StartLimits out;
  out.normal_force = force_at_rest(body, beta_0);
  if (out.normal_force == 0.0) {
    const double A = inertia_factor(body, body.theta_m, beta_0);
    const double a = energy_slope(body, body.theta_m, beta_0);
    const double q = 1.0 - body.eta_m * std::sin(body.theta_m - beta_0);
    out.normal_force_rate =
        -beta_rate / A * (2.0 * q * std::sin(beta_0) + body.k * a / q);
  }
  if (body.rolls()) {
    out.curvature = -1.0 / body.radius;
    out.fold_margin = -std::copysign(kInfinity, beta_rate);
  } else {
    out.curvature = std::copysign(kInfinity, beta_rate);
  }
  return out;
}

StartLimits start_limits(const Scene& scene, const PathState& start) {
  const Body& body = scene.body;
  if (scene.world.ordinary()) {
    return start_limits(body, start.beta, start.beta_rate);
  }
  if (scene.world.start_speed > 0.0) {
    const Kinematics moving = kinematics(scene, start);
    return {moving.R_n, 0.0, moving.kappa_b, moving.fold_margin};
  }
  // Where β₀ puts it: of a solution the place is right to its tolerance alone.
  const Point heavy = mass_centre(
      body, scene.path ? start.centre : start_of_centre(scene), body.theta_m);
  const Pull<double> G = field_at(scene, heavy.x, heavy.z);
  const double strength = std::hypot(G.x, G.z) / scene.gravity;
  const double tilt = std::atan2(G.z, G.x) - 0.5 * std::numbers::pi;
  Body turned = body;
  turned.theta_m -= tilt;
  StartLimits out = start_limits(turned, start.beta - tilt, start.beta_rate);
  out.normal_force *= strength;
  const double beta = start.beta - tilt;
  const double A = inertia_factor(turned, turned.theta_m, beta);
  const double a = strength * energy_slope(turned, turned.theta_m, beta);
  if (out.normal_force == 0.0) {
    out.normal_force_rate = out.normal_force_rate * strength +
                            body.eta_m * scene.world.air.linear * a *
                                std::cos(turned.theta_m - beta) /
                                (A * std::sqrt(A));
  }
  if (scene.world.losses.any()) {
    const double theta = body.theta_m;
    const double root = root_of_inertia(body, theta, start.beta);
    const auto with = [&](double& force, double per_u) {
      force = per_u * losses::load(body, scene.world.losses.factor(body), theta,
                                   start.beta, force);
    };
    with(out.normal_force, 1.0);
    with(out.normal_force_rate,
         root_of_inertia(scene, theta, start.beta) / root);
  }
  return out;
}

StartLimits start_limits_of_curvature(const Scene& scene,
                                      const PathState& start, double kappa_c) {
  StartLimits out;
  out.normal_force = start_limits(scene, start).normal_force;
  out.fold_margin = 1.0 - scene.body.folding_distance() * kappa_c;
  out.curvature = kappa_c / (1.0 - scene.body.radius * kappa_c);
  return out;
}

}  // namespace brachisto
