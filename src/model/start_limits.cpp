// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <cmath>
#include <limits>

#include "model/energy.hpp"
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

StartLimits start_limits_of_curvature(const Body& body, double beta_0,
                                      double kappa_c) {
  StartLimits out;
  out.normal_force = force_at_rest(body, beta_0);
  out.fold_margin = 1.0 - body.radius * kappa_c;
  out.curvature = kappa_c / out.fold_margin;
  return out;
}

}  // namespace brachisto
