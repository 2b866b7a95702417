// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/start_angle.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "brachisto/math/jet.hpp"
#include "math/nearest_minimum.hpp"
#include "math/roots.hpp"
#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto {

namespace {

/// Where the growth of speed from rest, w'/root_of_inertia(), is largest next
/// to a direction.
double fastest_direction(const Scene& scene, double near) {
  using On = math::Jet2<double, 1>;
  const auto lack = [&](double beta) {
    const TurningPoint<On> at = resting_at(scene, On::variable(beta, 0));
    const On growth =
        speed_gain(scene, at) / root_of_inertia(scene, at.theta, at.beta);
    return std::array{-growth.value, -growth.gradient[0], -growth.hessian[0]};
  };
  return math::nearest_minimum(lack, near);
}

}  // namespace

double start_angle(const Body& body) {
  constexpr double kHalfPi = std::numbers::pi / 2.0;
  // Exact by symmetry, and free of rounding so.
  if (!body.off_centred() || body.theta_m == 0.0) return kHalfPi;

  const double eta = body.eta_m;
  const double theta_m = body.theta_m;
  const auto first_term = [&](double beta) {
    return inertia_factor(body, theta_m, beta) * std::cos(beta);
  };
  const auto stationarity = [&](double beta) {
    return first_term(beta) -
           energy_slope(body, theta_m, beta) * eta * std::cos(theta_m - beta);
  };
  // a > 0 between these; there the first term alone is left, and it changes
  // sign from one end to the other.
  const double margin = std::asin(eta * std::cos(theta_m));
  const double first = -margin;
  const double last = 2.0 * kHalfPi + margin;
  return math::find_root(stationarity, first, last, first_term(first),
                         first_term(last));
}

double start_angle(const Scene& scene) {
  const World& world = scene.world;
  if (world.start_slope) return *world.start_slope;
  if (world.losses.any()) {
    Scene without = scene;
    without.world.losses = {};
    const double near = start_angle(without);
    // A bead that falls presses on nothing.
    return scene.body.rolls() ? fastest_direction(scene, near) : near;
  }
  if (!world.field_varies()) return start_angle(scene.body);
  // Fast, for the body is small beside the sphere; where it is not, bisecting
  // steps would not help either, and the certificate tells.
  constexpr int kMostSteps = 200;
  double beta = 0.5 * std::numbers::pi;
  for (int i = 0; i < kMostSteps; ++i) {
    Point centre{};
    if (scene.contact != Contact::Centre) {
      centre = centre_above({0.0, 0.0}, scene.body.radius, beta);
    }
    const Point heavy = mass_centre(scene.body, centre, scene.body.theta_m);
    const Pull<double> G = field_at(scene, heavy.x, heavy.z);
    const double tilt = std::atan2(G.z, G.x) - 0.5 * std::numbers::pi;
    Body turned = scene.body;
    turned.theta_m -= tilt;
    const double next = start_angle(turned) + tilt;
    if (std::abs(next - beta) <= 4e-16) break;
    beta = next;
  }
  return beta;
}

bool slope_at_A_is_open(const Scene& scene) {
  return scene.world.start_speed > 0.0 &&
         (scene.body.off_centred() || scene.world.losses.any() ||
          (scene.body.rolls() && scene.contact != Contact::Centre));
}

double initial_w(const Scene& scene) {
  if (scene.world.start_speed == 0.0) return 0.0;
  return pushed_w(scene, start_angle(scene));
}

}  // namespace brachisto
