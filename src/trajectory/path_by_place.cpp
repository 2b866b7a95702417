// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/path_by_place.hpp"

#include <algorithm>
#include <array>

namespace brachisto {

PathByPlace::PathByPlace(const ExtremalCurve& curve)
    : curve_(curve),
      in_world_(curve.scene().world.changes_rates()),
      scheme_(gauss_scheme(curve.mesh().degree)),
      first_length_(curve.without_slope(0, ElementPlace(scheme_, 1.0)).s),
      stages_(kStages, Basis(scheme_, 0.0)),
      leading_s_(leading_s(0)) {}

double PathByPlace::in_first(double s) const {
  constexpr int kMostSteps = 20;
  // The next step of Newton's method would be the square of this one, over the
  // place, on which w/t varies: rounding.
  constexpr double kLastStep = 1e-9;
  const double leading = leading_s(0);
  // At the start s ~ t².
  double t = std::sqrt(std::max(s / first_length_, 0.0));
  for (int i = 0; i < kMostSteps; ++i) {
    const Basis basis(scheme_, t);
    const ExtremalPoint point = curve_.without_slope(0, basis.place);
    if (!(point.w > 0.0)) break;
    const double step =
        (s - point.s - leading * basis.beyond) / pace(0, point.w);
    t += step;
    if (std::abs(step) < kLastStep * t) break;
  }
  return t;
}

PathByPlace::Place PathByPlace::at(int e, double t) {
  Basis& basis = stages_[stage_];
  stage_ = (stage_ + 1) % kStages;
  if (basis.place.t != t) basis = Basis(scheme_, t);
  if (e != element_) {
    element_ = e;
    leading_s_ = leading_s(e);
  }
  const ElementPlace& place = basis.place;
  const ExtremalPoint point = curve_.at(e, place);
  const std::array<double, 8> rates = curve_.rates(e, place);
  Place out;
  out.s = point.s + leading_s_ * basis.beyond;
  out.along = direction_of(point.beta);
  out.pace = pace(e, point.w);
  // ∂𝓗/∂β = 0 differentiated along the polynomials.
  const Scene& scene = curve_.scene();
  if (in_world_) {
    out.turning = slope_rate_along(curve_.scene_in(e), point.state(), point.p,
                                   point.beta, rates);
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
