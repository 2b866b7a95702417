// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/path_by_place.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

namespace brachisto {

PathByPlace::PathByPlace(const ExtremalCurve& curve)
    : curve_(curve),
      in_world_(curve.scene().world.changes_rates()),
      scheme_(collocation_scheme(curve.mesh().degree)),
      rule_(math::gauss_legendre((curve.mesh().degree + 2) / 2)),
      bases_(kStages, ElementPlace(scheme_, 0.0)) {
  for (const double t : scheme_.nodes.nodes()) {
    first_w_.push_back(curve.without_slope(0, ElementPlace(scheme_, t)).w);
  }
  first_length_ =
      curve.rolling_time() * share(0) * speed_in_first(1.0).integral;
}

PathByPlace::Speed PathByPlace::speed_in_first(double t) const {
  std::array<double, kLargestDegree + 1> storage{};
  const auto basis = std::span(storage).first(first_w_.size());
  const auto w = [&](double place) {
    scheme_.nodes.evaluate(place, basis);
    return std::inner_product(basis.begin(), basis.end(), first_w_.begin(),
                              0.0);
  };
  double mean = 0.0;
  for (std::size_t i = 0; i < rule_.points.size(); ++i) {
    mean += rule_.weights[i] * w(t * rule_.points[i]);
  }
  return {w(t), t * mean};
}

double PathByPlace::in_first(double s) const {
  constexpr int kMostSteps = 20;
  // The next step of Newton's method would be the square of this one, over the
  // place, on which w/t varies: rounding.
  constexpr double kLastStep = 1e-9;
  const double hU = curve_.rolling_time() * share(0);
  // At the start s ~ t².
  double t = std::sqrt(std::max(s / first_length_, 0.0));
  for (int i = 0; i < kMostSteps; ++i) {
    const Speed now = speed_in_first(t);
    if (!(now.w > 0.0)) break;
    const double step = (s / hU - now.integral) / now.w;
    t += step;
    if (std::abs(step) < kLastStep * t) break;
  }
  return t;
}

const ElementPlace& PathByPlace::basis(double t) {
  ElementPlace& kept = bases_[stage_];
  stage_ = (stage_ + 1) % kStages;
  if (kept.t != t) kept = ElementPlace(scheme_, t);
  return kept;
}

PathByPlace::Place PathByPlace::at(int e, double t) {
  const ElementPlace& place = basis(t);
  const ExtremalPoint point = curve_.at(e, place);
  const std::array<double, 8> rates = curve_.rates(e, place);
  Place out;
  out.along = direction_of(point.beta);
  out.pace = curve_.rolling_time() * curve_.mesh().length(e) * point.w;
  // ∂𝓗/∂β = 0 differentiated along the polynomials.
  const Scene& scene = curve_.scene();
  if (in_world_) {
    out.turning = in_world::slope_rate_along(curve_.scene_in(e), point.state(),
                                             point.p, point.beta, rates);
    return out;
  }
  const auto [beta, cosine, sine] = out.along;
  const double theta_rate = rates[2], w_rate = rates[3], p_w_rate = rates[7];
  const SlopeHamiltonian h = slope_hamiltonian(
      scene.body, scene.gravity, {point.theta, point.w}, point.p, beta);
  const double pull_z = point.w * point.p.p_z + point.p.p_w * scene.gravity;
  const double d2_root =
      h.d2_beta + point.w * point.p.p_x * cosine + pull_z * sine;
  out.turning = (d2_root * theta_rate -
                 (point.p.p_z * cosine - point.p.p_x * sine) * w_rate -
                 scene.gravity * cosine * p_w_rate) /
                h.d2_beta;
  return out;
}

}  // namespace brachisto
