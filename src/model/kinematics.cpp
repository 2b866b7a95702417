// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <cmath>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

Kinematics kinematics(const Body& body, double gravity,
                      const PathState& state) {
  const double eta = body.eta_m;
  const double r = body.radius;
  const double w = state.w;
  const double cos_beta = std::cos(state.beta);
  const double sin_beta = std::sin(state.beta);
  const double cos_theta = std::cos(state.theta);
  const double sin_theta = std::sin(state.theta);
  const double A = inertia_factor(body, state.theta, state.beta);
  const double a = energy_slope(body, state.theta, state.beta);

  Kinematics out;
  out.mass_centre = {state.centre.x + r * eta * cos_theta,
                     state.centre.z + r * eta * sin_theta};
  out.contact = track_below(state.centre, r, state.beta);
  out.v_c = w / std::sqrt(A);
  double theta_rate = 0.0;
  if (body.rolls()) {
    out.omega = out.v_c / r;
    theta_rate = w / r;
  }

  const double A_rate = -2.0 * eta * std::cos(state.theta - state.beta) *
                        (theta_rate - state.beta_rate);
  const double v_dot = gravity * a / A - w * A_rate / (2.0 * A * A);
  const double across = w * state.beta_rate / A;  // v_c² κ_c
  // r_m (θ̈, θ̇²) with r θ̈ = v̇, r θ̇² = v_c ω.
  const double swing = eta * v_dot;
  const double centripetal = eta * out.v_c * out.omega;
  const double x_ddot = v_dot * cos_beta - across * sin_beta -
                        swing * sin_theta - centripetal * cos_theta;
  const double z_ddot = v_dot * sin_beta + across * cos_beta +
                        swing * cos_theta - centripetal * sin_theta;
  const double R_x = x_ddot / gravity;
  const double R_z = z_ddot / gravity - 1.0;
  out.R_n = R_x * sin_beta - R_z * cos_beta;
  out.R_t = R_x * cos_beta + R_z * sin_beta;

  // κ_b = κ_c / (1 − r κ_c) = β_u / (w − r β_u), also at w = 0.
  const double along_track = w - r * state.beta_rate;
  out.kappa_b = state.beta_rate / along_track;
  out.fold_margin = body.rolls() ? along_track / w : 1.0;
  return out;
}

}  // namespace brachisto
