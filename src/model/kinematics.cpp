// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/model/kinematics.hpp"

#include <cmath>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"

namespace brachisto {

namespace {

/// What acts beside the track, and what it does to w.
struct Acting {
  double pull_x, pull_z;  ///< forces per m g
  double w_rate;          ///< dw/du
};

/// Sines and cosines of β and θ.
struct Sines {
  double sin_beta, cos_beta, sin_theta, cos_theta;
};

/// \param acts  what acts in those directions
template <class Acts>
Kinematics moved_by(const Acts& acts, const Body& body, double gravity,
                    const PathState& state) {
  const double eta = body.eta_m;
  const double r = body.radius;
  const double w = state.w;
  const double cos_beta = std::cos(state.beta);
  const double sin_beta = std::sin(state.beta);
  const double cos_theta = std::cos(state.theta);
  const double sin_theta = std::sin(state.theta);
  const double A = inertia_factor(body, state.theta, state.beta);
  const Acting acting = acts(Sines{sin_beta, cos_beta, sin_theta, cos_theta});

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
  const double v_dot = acting.w_rate / A - w * A_rate / (2.0 * A * A);
  const double across = w * state.beta_rate / A;  // v_c² κ_c
  // r_m (θ̈, θ̇²) with r θ̈ = v̇, r θ̇² = v_c ω.
  const double swing = eta * v_dot;
  const double centripetal = eta * out.v_c * out.omega;
  const double x_ddot = v_dot * cos_beta - across * sin_beta -
                        swing * sin_theta - centripetal * cos_theta;
  const double z_ddot = v_dot * sin_beta + across * cos_beta +
                        swing * cos_theta - centripetal * sin_theta;
  const double R_x = x_ddot / gravity - acting.pull_x;
  const double R_z = z_ddot / gravity - acting.pull_z;
  out.R_n = R_x * sin_beta - R_z * cos_beta;
  out.R_t = R_x * cos_beta + R_z * sin_beta;

  // κ_b = κ_c / (1 − r κ_c) = β_u / (w − r β_u), also at w = 0.
  const double along_track = w - r * state.beta_rate;
  out.kappa_b = state.beta_rate / along_track;
  out.fold_margin = body.rolls() ? along_track / w : 1.0;
  if (body.fold_ratio != 1.0) {
    out.fold_margin = (w - body.folding_distance() * state.beta_rate) / w;
  }
  return out;
}

}  // namespace

double curvature_of_centre(const Body& body, const Kinematics& motion) {
  return body.rolls() ? (1.0 - motion.fold_margin) / body.folding_distance()
                      : motion.kappa_b;
}

Kinematics kinematics(const Body& body, double gravity,
                      const PathState& state) {
  const auto weight = [&](const Sines& d) {
    return Acting{0.0, 1.0, gravity * (d.sin_beta + d.cos_theta * body.eta_m)};
  };
  return moved_by(weight, body, gravity, state);
}

Kinematics kinematics(const Scene& scene, const PathState& state) {
  const Body& body = scene.body;
  const double g = scene.gravity;
  if (!scene.world.changes_rates()) return kinematics(body, g, state);
  const double root = root_of_inertia(body, state.theta, state.beta);
  PathState moving = state;
  double taken = 0.0;  // by losses, of dw/du
  const auto world = [&](const Sines& d) {
    const Point heavy = mass_centre(body, state.centre, state.theta);
    const Pull<double> G = field_at(scene, heavy.x, heavy.z);
    const double brakes = drag(scene.world.air, moving.w / root);
    return Acting{(G.x - brakes * d.cos_beta) / g,
                  (G.z - brakes * d.sin_beta) / g,
                  work_gain(scene, state.centre.x, state.centre.z, state.theta,
                            moving.w, state.beta, root) -
                      taken};
  };
  const Losses& lost = scene.world.losses;
  if (lost.any()) {
    const double share = root / root_of_inertia(scene, state.theta, state.beta);
    moving.w *= share;
    moving.beta_rate *= share;
    const double c = lost.factor(body);
    taken = c * g *
            losses::load(body, c, state.theta, state.beta,
                         moved_by(world, body, g, moving).R_n);
  }
  return moved_by(world, body, g, moving);
}

}  // namespace brachisto
