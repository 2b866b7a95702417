// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/acceleration.hpp"

#include <cmath>

#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

/// v̇ = v̇⁰ − c g R_n/A, g R_n⁰ by Newton's law across the track; out of line
/// with all that it needs, for most bodies are not braked.
[[gnu::noinline, gnu::cold]] double braked(const Scene& scene, double s,
                                           double v, Point place,
                                           const Direction& along,
                                           double v_kappa, double without) {
  const Body& body = scene.body;
  const double c = scene.world.losses.factor(body), eta = body.eta_m;
  const double turning = rotation_per_length(body);
  const double theta = body.theta_m + s * turning;
  const double A = inertia_factor(body, theta, along.beta);
  const double eta_cos = eta * std::cos(theta - along.beta);
  const double eta_sin = eta * std::sin(theta - along.beta);
  const Pull<double> G = pull_on(scene, place.x, place.z, theta);
  const double R = G.z * along.cosine - G.x * along.sine - v * v_kappa -
                   eta_cos * without + eta_sin * v * v * turning;
  return without - c * R / (A - c * eta_cos);
}

}  // namespace

double rotation_per_length(const Body& body) {
  return body.rolls() ? 1.0 / body.radius : 0.0;
}

double acceleration(const Scene& scene, double s, double v, Point place,
                    const Direction& along, double v_kappa) {
  const Body& body = scene.body;
  const double turning = rotation_per_length(body);
  const double theta = body.theta_m + s * turning;
  const double cosine = std::cos(theta), sine = std::sin(theta);
  const double eta = body.eta_m, r_m = body.radius * eta;
  const double A = inertia_factor(body, theta, along.beta);
  const double A_s_v2 = -2.0 * eta *
                        (cosine * along.cosine + sine * along.sine) * v *
                        (v * turning - v_kappa);
  const Pull<double> G =
      field_at(scene, place.x + r_m * cosine, place.z + r_m * sine);
  const double force = G.x * (along.cosine - eta * sine) +
                       G.z * (along.sine + eta * cosine) -
                       drag(scene.world.air, v);
  const double without = (force - 0.5 * A_s_v2) / A;
  if (!scene.world.losses.any()) return without;
  return braked(scene, s, v, place, along, v_kappa, without);
}

}  // namespace brachisto
