// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brachisto/math/jet.hpp"
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
        value_of(held.limit, scene, resting_at(scene, On::variable(beta, 0)));
    const double change = (held.bound - value.value) / value.gradient[0];
    beta += change;
    if (!(std::abs(change) > kRounding)) break;
  }
  return beta;
}

}  // namespace

Departure::Departure(const Scene& natural, const std::optional<HeldLimit>& held,
                     double near, const std::optional<HeldLimit>& corner)
    : scene_(natural), held_(held), corner_(corner) {
  if (!held) {
    if (has_optimal_ends(scene_))
      refusal_ = "it leaves an optimal contact freely";
    const std::vector<PathInequality> limits =
        inequalities(scene_.body, scene_.limits);
    if (std::ranges::any_of(limits, &PathInequality::bounds_force)) {
      slope_ = corner_ && natural.world.start_speed == 0.0
                   ? slope_at_rest(scene_, *corner_, near)
                   : known_start_slope(scene_, limits);
    }
  } else if (held->limit.bounds_force() && natural.world.start_speed == 0.0) {
    kind_ = Kind::Forced;
    slope_ = slope_at_rest(scene_, *held, near);
    w_1_ = speed_gain(scene_, resting_at(scene_, *slope_));
    leave_along(*held);
  } else if (held->limit.bounds_control()) {
    kind_ = Kind::Turning;
    if (natural.world.start_speed > 0.0) return;
    const std::vector<PathInequality> limits =
        inequalities(scene_.body, scene_.limits);
    if (has_optimal_ends(scene_) || bound_valleys(limits)) return;
    slope_ = start_angle_under(scene_, limits);
    if (!slope_) refusal_ = "no direction at rest keeps the limits";
  } else {
    refusal_ = "it starts along a boundary";
  }
}

/// β₁ and β₂ of β = β₀ + β₁ u + β₂ u² + … make the first two derivatives by u
/// of the limit's value vanish, which are affine in them, one after the other.
void Departure::leave_along(const HeldLimit& held) {
  using On = math::Jet2<double, 1>;
  const auto derivatives = [&] {
    const On c = value_of(held.limit, scene_, after(On::variable(0.0, 0)));
    return std::array{c.gradient[0], c.hessian[0]};
  };
  for (std::size_t i = 0; i < 2; ++i) {
    // w'' follows from β₁.
    const auto value = [&](double rise) {
      rise_[i] = rise;
      if (i == 0)
        w_2_ = speed_gain(scene_, after(On::variable(0.0, 0))).gradient[0];
      return derivatives()[i];
    };
    const double without = value(0.0), with = value(1.0);
    value(without / (without - with));
  }
}

State Departure::left_rest(double u) const {
  const TurningPoint<double> left = after(u);
  State y{};
  y[kX] = left.x;
  y[kZ] = left.z;
  y[kTheta] = left.theta;
  y[kW] = left.w;
  y[kBeta] = left.beta;
  return y;
}

}  // namespace brachisto::arcs
