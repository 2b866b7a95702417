// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/canonical_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "brachisto/model/inertia.hpp"

namespace brachisto::shooting {

double inverse_radius(const Body& body) {
  return body.rolls() ? 1.0 / body.radius : 1.0;
}

CanonicalFlow::CanonicalFlow(const Body& body, double gravity,
                             const FlowParameters& parameters)
    : body_(body),
      g_(gravity),
      inverse_radius_(shooting::inverse_radius(body)),
      parameters_(parameters) {
  body_.eta_m = parameters.eta;
}

bool CanonicalFlow::find_slope(const State& y, double near,
                               Slope& slope) const {
  const auto& [p_x, p_z, eta] = parameters_;
  const double beta = minimising_slope(body_, g_, {y[kTheta], y[kW]},
                                       {p_x, p_z, y[kPTheta], y[kPW]}, near);
  if (!std::isfinite(beta)) return false;
  const double c = std::cos(beta);
  const double s = std::sin(beta);
  const double sin_d = std::sin(y[kTheta] - beta);
  const double cos_d = std::cos(y[kTheta] - beta);
  // A = 1 + η² + k − 2 η sin δ, so R R_δ = −η cos δ and R R_η = η − sin δ.
  const double R = std::sqrt(inertia_factor(body_, y[kTheta], beta));
  const double R_d = -eta * cos_d / R;
  const double R_eta = (eta - sin_d) / R;
  slope = {.beta = beta,
           .sin_beta = s,
           .cos_beta = c,
           .sin_theta = std::sin(y[kTheta]),
           .cos_theta = std::cos(y[kTheta]),
           .R = R,
           .R_d = R_d,
           .R_dd = (eta * sin_d - R_d * R_d) / R,
           .R_eta = R_eta,
           .R_d_eta = -(cos_d + R_d * R_eta) / R,
           .p_s = p_x * c + p_z * s,
           .p_n = p_z * c - p_x * s,
           .legendre = 0.0};
  slope.legendre = slope.R_dd - y[kW] * slope.p_s - y[kPW] * g_ * s;
  return slope.legendre > 0.0;
}

State CanonicalFlow::rates(const State& y, const Slope& slope) const {
  const auto& [x, z, theta, w, p_theta, p_w] = y;
  const double eta = parameters_.eta;
  return {w * slope.cos_beta,
          w * slope.sin_beta,
          w * inverse_radius_,
          g_ * (slope.sin_beta + eta * slope.cos_theta),
          -slope.R_d + p_w * g_ * eta * slope.sin_theta,
          -slope.p_s - p_theta * inverse_radius_};
}

// ∂𝓗/∂β = −R_δ + w p_n + p_w g cos β stays zero, which determines dβ.
double CanonicalFlow::slope_variation(const State& y, const Slope& slope,
                                      const State& v,
                                      const FlowParameters& dp) const {
  const double w = y[kW];
  const double c = slope.cos_beta;
  const double s = slope.sin_beta;
  const double change = -slope.R_dd * v[kTheta] + slope.p_n * v[kW] +
                        g_ * c * v[kPW] + w * (dp.p_z * c - dp.p_x * s) -
                        slope.R_d_eta * dp.eta;
  return -change / slope.legendre;
}

State CanonicalFlow::variation_rates(const State& y, const Slope& slope,
                                     const State& v,
                                     const FlowParameters& dp) const {
  const double w = y[kW];
  const double p_w = y[kPW];
  const double c = slope.cos_beta;
  const double s = slope.sin_beta;
  const double eta = parameters_.eta;
  const double d_beta = slope_variation(y, slope, v, dp);
  const double d_R_d =
      slope.R_dd * (v[kTheta] - d_beta) + slope.R_d_eta * dp.eta;
  const double d_p_s = slope.p_n * d_beta + dp.p_x * c + dp.p_z * s;
  return {v[kW] * c - w * s * d_beta,
          v[kW] * s + w * c * d_beta,
          v[kW] * inverse_radius_,
          g_ * (c * d_beta - eta * slope.sin_theta * v[kTheta] +
                dp.eta * slope.cos_theta),
          -d_R_d + g_ * (eta * slope.sin_theta * v[kPW] +
                         p_w * eta * slope.cos_theta * v[kTheta] +
                         p_w * slope.sin_theta * dp.eta),
          -d_p_s - v[kPTheta] * inverse_radius_};
}

}  // namespace brachisto::shooting
