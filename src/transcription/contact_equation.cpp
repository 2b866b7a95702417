// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/contact_equation.hpp"

#include <cmath>
#include <limits>

#include "model/hamiltonian.hpp"

namespace brachisto {

ContactEquation::ContactEquation(Transcription& problem) : problem_(problem) {
  const VariableLayout& layout = problem.layout();
  const int last = layout.num_points();
  fixed_rates_.index = {layout.state(last, StateComponent::X),
                        layout.state(last, StateComponent::Z)};
  fixed_rates_.value = {0.0, 0.0};
}

void ContactEquation::set_parameter(double phi) {
  phi_ = phi;
  problem_.set_end_angle(phi);
  // C_B = (L + r sin φ, H − r cos φ)
  const double r = problem_.scene().body.radius;
  fixed_rates_.value = {r * std::cos(phi), r * std::sin(phi)};
}

const nlp::TangencyCondition::Linearisation& ContactEquation::linearise(
    std::span<const double> x, std::span<const double> lambda) {
  const std::optional<Transcription::End> end = problem_.end(x, lambda);
  if (!end) {
    at_.residual = std::numeric_limits<double>::quiet_NaN();
    return at_;
  }
  const Costates& p = end->p;
  const double w = end->state.w;
  const SlopeHamiltonian h = slope_hamiltonian(
      problem_.scene().body, problem_.scene().gravity, end->state, p, phi_);
  const double cos_phi = std::cos(phi_);
  const double sin_phi = std::sin(phi_);
  const double by_w = p.p_z * cos_phi - p.p_x * sin_phi;
  // ∂²√A/∂β∂θ = −∂²√A/∂β²
  const double along = w * (p.p_x * cos_phi + p.p_z * sin_phi);
  const double by_theta = -(h.d2_beta + along);
  at_.residual = h.d_beta;
  at_.by_parameter = h.d2_beta;
  const auto fill = [&](const std::vector<Transcription::End::Rate>& rates,
                        nlp::SparseVector& out) {
    out.index.clear();
    out.value.clear();
    for (const auto& rate : rates) {
      out.index.push_back(rate.index);
      out.value.push_back(w * (rate.p_z * cos_phi - rate.p_x * sin_phi) /
                              end->divisor +
                          (by_w * rate.w + by_theta * rate.theta));
    }
  };
  fill(end->by_x, at_.by_x);
  fill(end->by_lambda, at_.by_lambda);
  return at_;
}

}  // namespace brachisto
