// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/path_by_length.hpp"

#include <algorithm>
#include <cmath>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

PathByLength::PathByLength(const ExtremalCurve& curve)
    : curve_(curve),
      scheme_(collocation_scheme(curve.mesh().degree)),
      rule_(math::gauss_legendre((curve.mesh().degree + 2) / 2)) {
  const Mesh& mesh = curve.mesh();
  for (int node = 0; node < mesh.num_nodes(); ++node) {
    const ExtremalPoint at = curve.at_node(node);
    theta_.push_back(at.theta);
    w_.push_back(at.w);
    p_w_.push_back(at.p.p_w);
  }
  ends_.push_back(0.0);
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    ends_.push_back(ends_.back() + curve.rolling_time() * mesh.length(e) *
                                       speed(e, 1.0).integral);
  }
}

double PathByLength::combine(int e, const std::vector<double>& values,
                             const std::vector<double>& nodal) const {
  const auto first = static_cast<std::size_t>(e * scheme_.degree);
  double sum = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    sum += values[n] * nodal[first + n];
  }
  return sum;
}

PathByLength::Speed PathByLength::speed(int e, double t) const {
  std::vector<double> basis(static_cast<std::size_t>(scheme_.nodes.size()));
  const auto w = [&](double place) {
    scheme_.nodes.evaluate(place, basis);
    return combine(e, basis, w_);
  };
  double integral = 0.0;
  for (std::size_t i = 0; i < rule_.points.size(); ++i) {
    integral += t * rule_.weights[i] * w(t * rule_.points[i]);
  }
  return {w(t), integral};
}

PathByLength::Place PathByLength::at(int e, double s) const {
  const double hU = curve_.rolling_time() * curve_.mesh().length(e);
  // Solve hU ∫₀ᵗ w = s − s_e. At the start s ~ t², hence the root.
  double t = (s - end(e)) / (end(e + 1) - end(e));
  if (e == 0) t = std::sqrt(std::max(t, 0.0));
  Speed now = speed(e, t);
  constexpr int kMostSteps = 20;
  for (int i = 0; i < kMostSteps && now.w > 0.0; ++i) {
    const double step = (s - end(e) - hU * now.integral) / (hU * now.w);
    t += step;
    now = speed(e, t);
    if (std::abs(step) < 1e-15) break;
  }

  // ∂𝓗/∂β = 0 differentiated along the polynomials.
  const ExtremalPoint point = curve_.at(e, t);
  const Scene& scene = curve_.scene();
  const SlopeHamiltonian h = slope_hamiltonian(
      scene.body, scene.gravity, {point.theta, point.w}, point.p, point.beta);
  const double sine = std::sin(point.beta);
  const double cosine = std::cos(point.beta);
  const double pull_z = point.w * point.p.p_z + point.p.p_w * scene.gravity;
  const double d2_root =
      h.d2_beta + point.w * point.p.p_x * cosine + pull_z * sine;
  std::vector<double> slopes(static_cast<std::size_t>(scheme_.nodes.size()));
  scheme_.nodes.differentiate(t, slopes);
  const double rate =
      (d2_root * combine(e, slopes, theta_) -
       (point.p.p_z * cosine - point.p.p_x * sine) * combine(e, slopes, w_) -
       scene.gravity * cosine * combine(e, slopes, p_w_)) /
      h.d2_beta;
  return {point.beta, rate / (hU * point.w)};
}

}  // namespace brachisto
