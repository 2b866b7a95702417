// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/acceleration.hpp"

#include <cmath>

#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

struct Instant {
  const Body& body;
  double loss;
  const Pull<double>& G;
  const Direction& along;
  double cosine, sine;  ///< of θ
  double A, v, v_kappa;
};

/// v̇ = v̇⁰ − c g R_n/A, g R_n⁰ by Newton's law across the track; out of line,
/// for most bodies are not braked.
[[gnu::noinline, gnu::cold]] double braked(const Instant& at, double without) {
  const Direction& along = at.along;
  const double eta = at.body.eta_m;
  const double turning = rotation_per_length(at.body);
  const double cos_delta = at.cosine * along.cosine + at.sine * along.sine;
  const double sin_delta = at.sine * along.cosine - at.cosine * along.sine;
  const double R =
      at.G.z * along.cosine - at.G.x * along.sine - at.v * at.v_kappa -
      eta * (without * cos_delta - at.v * at.v * turning * sin_delta);
  return without - at.loss * R / (at.A - at.loss * eta * cos_delta);
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
  return braked({body, scene.world.losses.factor(), G, along, cosine, sine, A,
                 v, v_kappa},
                without);
}

}  // namespace brachisto
