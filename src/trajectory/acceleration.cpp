// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/acceleration.hpp"

#include "model/inertia.hpp"

namespace brachisto {

double acceleration(const Scene& scene, double s, double v, Point place,
                    const Direction& along, double v_kappa) {
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
