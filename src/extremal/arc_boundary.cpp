// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_boundary.hpp"

#include <cmath>

#include "math/jet2.hpp"
#include "model/contact.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "model/start_under_limits.hpp"

namespace brachisto::arcs {

namespace {

/// The slope at rest next to `near` at which a limit on forces holds.
double slope_at_rest(const Scene& scene, const HeldLimit& held, double near) {
  using On = math::Jet1<double, 1>;
  constexpr int kMostSteps = 30;
  constexpr double kRounding = 1e-15;
  double beta = near;
  for (int i = 0; i < kMostSteps; ++i) {
    const On value =
        value_of(held.limit, scene.body, scene.gravity,
                 TurningPoint<On>{On(0.0), On(0.0), On(scene.body.theta_m),
                                  On(0.0), On::variable(beta, 0), On(0.0)});
    const double change = (held.bound - value.value) / value.gradient[0];
    beta += change;
    if (!(std::abs(change) > kRounding)) break;
  }
  return beta;
}

/// β₂ of β = β₀ + β₂ u² + …, with which the path leaves rest so that the limit
/// goes on to hold. With w = W u and θ = θ_m + W u²/2r the terms in u² of its
/// value are
///
///     c_θ W/2r + c_ww W²/2 + (c_β + 2 W c_wq) β₂ = 0.
double rise_from_rest(const Scene& scene, const HeldLimit& held, double slope) {
  using On = math::Jet2<double, 4>;
  const Body& body = scene.body;
  const On c =
      value_of(held.limit, body, scene.gravity,
               TurningPoint<On>{On(0.0), On(0.0), On::variable(body.theta_m, 0),
                                On::variable(0.0, 1), On::variable(slope, 2),
                                On::variable(0.0, 3)});
  const double W = scene.gravity * energy_slope(body, body.theta_m, slope);
  const auto second = [&](int i, int j) { return c.hessian[On::pair(i, j)]; };
  return -(c.gradient[0] * 0.5 * W * rotation_per_length(scene) +
           0.5 * second(1, 1) * W * W) /
         (c.gradient[2] + 2.0 * W * second(3, 1));
}

}  // namespace

Departure::Departure(const Scene& natural, const std::optional<HeldLimit>& held,
                     double near)
    : scene_(natural) {
  if (!held) {
    if (has_optimal_ends(scene_))
      refusal_ = "it leaves an optimal contact freely";
  } else if (held->limit.bounds_force()) {
    kind_ = Kind::Forced;
    slope_ = slope_at_rest(scene_, *held, near);
    rise_ = rise_from_rest(scene_, *held, *slope_);
  } else if (held->limit.bounds_control()) {
    kind_ = Kind::Turning;
    const std::vector<PathInequality> limits =
        inequalities(scene_.body, scene_.limits);
    if (has_optimal_ends(scene_) || bound_valleys(limits)) return;
    slope_ = start_angle_under(scene_.body, limits);
    if (!slope_) refusal_ = "no direction at rest keeps the limits";
  } else {
    refusal_ = "it starts along a boundary";
  }
}

State Departure::left_rest(double u) const {
  const Body& body = scene_.body;
  const Point centre =
      centre_above({0.0, 0.0}, contact_radius(scene_), *slope_);
  const double w =
      scene_.gravity * energy_slope(body, body.theta_m, *slope_) * u;
  const double s = 0.5 * w * u;
  State y{};
  y[kX] = centre.x + s * std::cos(*slope_);
  y[kZ] = centre.z + s * std::sin(*slope_);
  y[kTheta] = body.theta_m + s * rotation_per_length(scene_);
  y[kW] = w;
  y[kBeta] = *slope_ + rise_ * u * u;
  return y;
}

}  // namespace brachisto::arcs
