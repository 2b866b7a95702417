// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "design/design_space.hpp"

#include <cmath>
#include <numbers>

namespace brachisto {

namespace {

/// A centre of mass so near the axis is on it: what is left is rounding.
constexpr double kOnAxis = 1e-12;
/// A body so little beyond the rim is on it: Newton's steps end there by the
/// squares of their lengths.
constexpr double kOnRim = 1e-9;

}  // namespace

double angle_next_to(double angle, double other) {
  return other + std::remainder(angle - other, 2.0 * std::numbers::pi);
}

Traits traits_of(const Body& body) {
  return {body.eta_m * std::cos(body.theta_m),
          body.eta_m * std::sin(body.theta_m), body.k, body.radius};
}

Body body_of(const Traits& traits, const Body& like) {
  Body body = like;
  body.eta_m = std::hypot(traits[0], traits[1]);
  if (body.eta_m > kOnAxis) {
    body.theta_m =
        angle_next_to(std::atan2(traits[1], traits[0]), like.theta_m);
  } else if (body.eta_m <= kOnAxis) {
    body.eta_m = 0.0;
  }
  body.k = traits[2];
  body.radius = traits[3];
  const double beyond = body.k - largest_k(body.eta_m);
  if (beyond > 0.0 && beyond < kOnRim) {
    // What a design holds is as in the other body.
    if (body.k != like.k) {
      body.k = largest_k(body.eta_m);
    } else {
      body.eta_m = std::sqrt(1.0 - body.k);
    }
  }
  return body;
}

std::unique_ptr<DesignSpace> design_space(const DesignPlan& plan,
                                          const Body& body) {
  return plan.free_parts.empty() ? offset_space(plan, body)
                                 : parts_space(plan, body);
}

}  // namespace brachisto
