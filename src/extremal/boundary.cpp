// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/boundary.hpp"

#include <cmath>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"
#include "model/start_angle.hpp"

namespace brachisto::shooting {

InitialState start_conditions(const Scene& natural, double eta) {
  Scene scene = natural;
  scene.body.eta_m = eta;
  const Body& body = scene.body;
  const double g = scene.gravity;
  const double theta = body.theta_m;
  const double beta = brachisto::start_angle(body);
  const double delta = theta - beta;
  const double R = std::sqrt(inertia_factor(body, theta, beta));
  const double a = energy_slope(body, theta, beta);
  const Point centre = start_of_centre(scene);

  InitialState start{.x = centre.x,
                     .z = centre.z,
                     .theta = theta,
                     .w = 0.0,
                     .p_w = -R / (g * a),
                     .beta = beta,
                     .dx_deta = 0.0,
                     .dz_deta = 0.0,
                     .dp_w_deta = 0.0};

  // R/a is stationary in β, so that only its explicit dependence on η counts.
  const double R_eta = (eta - std::sin(delta)) / R;
  start.dp_w_deta = -(R_eta / a - R * std::cos(theta) / (a * a)) / g;
  if (scene.contact == Contact::Centre) return start;

  // β₀ keeps ∂𝓗/∂β = −R_δ + p_w g cos β zero.
  const double R_d = -eta * std::cos(delta) / R;
  const double R_dd = (eta * std::sin(delta) - R_d * R_d) / R;
  const double R_d_eta = -(std::cos(delta) + R_d * R_eta) / R;
  const double legendre = R_dd - start.p_w * g * std::sin(beta);
  const double dbeta_deta =
      (R_d_eta - g * std::cos(beta) * start.dp_w_deta) / legendre;
  start.dx_deta = body.radius * std::cos(beta) * dbeta_deta;
  start.dz_deta = body.radius * std::sin(beta) * dbeta_deta;
  return start;
}

EndSlide end_slide(const Scene& natural, double phi) {
  if (natural.contact == Contact::Centre) return {0.0, 0.0};
  // C_B(φ) = B + r (sin φ, −cos φ).
  return {natural.body.radius * std::cos(phi),
          natural.body.radius * std::sin(phi)};
}

}  // namespace brachisto::shooting
