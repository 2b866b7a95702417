// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The equation of motion of a body on a given path, in any world: for numbers
/// and jets.

#pragma once

#include <cmath>

#include "brachisto/model/scene.hpp"
#include "model/field.hpp"
#include "trajectory/path_by_place.hpp"

namespace brachisto {

/// dθ/ds.
[[nodiscard]] inline double rotation_per_length(const Body& body) {
  return body.rolls() ? 1.0 / body.radius : 0.0;
}

/// Where a body is on its way, and how it moves there.
///
/// \tparam Scalar  double, or a jet by numbers of the body
template <class Scalar>
struct OnTheWay {
  double s = 0.0;  ///< length that the centre has come [m]
  Point place;     ///< of the centre [m]; without effect in a uniform field
  Direction along;
  Scalar v{};        ///< ṡ
  Scalar v_kappa{};  ///< ṡ κ_c
  Scalar A{};        ///< inertia factor
};

/// s̈ without losses, by
///
///     A s̈ = G·(cos β − η sin θ, sin β + η cos θ) − D − ½ A_s ṡ²,
///     A_s = −2 η cos(θ − β) (1/r − κ_c),
///
/// with the field G at the centre of mass and the drag D on the centre: in a
/// uniform field without air g (sin β + η cos θ) − ½ A_s ṡ². Neither energy nor
/// the rolling time enter.
template <class Scalar>
[[nodiscard]] Scalar acceleration_without_losses(const Scene& scene,
                                                 const OnTheWay<Scalar>& at) {
  const Body& body = scene.body;
  const double turning = rotation_per_length(body);
  const double theta = body.theta_m + at.s * turning;
  const double cosine = std::cos(theta), sine = std::sin(theta);
  const double eta = body.eta_m, r_m = body.radius * eta;
  const Scalar A_s_v2 =
      at.v * (-2.0 * eta * (cosine * at.along.cosine + sine * at.along.sine)) *
      (at.v * turning - at.v_kappa);
  const Pull<double> G =
      field_at(scene, at.place.x + r_m * cosine, at.place.z + r_m * sine);
  const Scalar force = Scalar(G.x * (at.along.cosine - eta * sine) +
                              G.z * (at.along.sine + eta * cosine)) -
                       drag(scene.world.air, at.v);
  return (force - A_s_v2 * 0.5) / at.A;
}

/// v̇ = v̇⁰ − c g R_n/A, g R_n⁰ by Newton's law across the track; out of line
/// with all that it needs, for most bodies are not braked.
///
/// \param c        that of the losses
/// \param without  v̇⁰
template <class Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] Scalar acceleration_with_losses(
    const Scene& scene, const OnTheWay<Scalar>& at, const Scalar& c,
    const Scalar& without) {
  const Body& body = scene.body;
  const double turning = rotation_per_length(body);
  const double theta = body.theta_m + at.s * turning;
  const double eta_cos = body.eta_m * std::cos(theta - at.along.beta);
  const double eta_sin = body.eta_m * std::sin(theta - at.along.beta);
  const Pull<double> G = pull_on(scene, at.place.x, at.place.z, theta);
  const Scalar R = Scalar(G.z * at.along.cosine - G.x * at.along.sine) -
                   at.v * at.v_kappa - without * eta_cos +
                   at.v * eta_sin * at.v * turning;
  return without - c * R / (at.A - c * eta_cos);
}

/// s̈ in the world of a scene.
[[nodiscard]] inline double acceleration(const Scene& scene, double s, double v,
                                         Point place, const Direction& along,
                                         double v_kappa) {
  const double theta = scene.body.theta_m + s * rotation_per_length(scene.body);
  const OnTheWay<double> at{
      s, place,   along,
      v, v_kappa, inertia_factor(scene.body, theta, along.beta)};
  const double without = acceleration_without_losses(scene, at);
  const Losses& losses = scene.world.losses;
  if (!losses.any()) return without;
  return acceleration_with_losses(scene, at, losses.factor(scene.body),
                                  without);
}

}  // namespace brachisto
