// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/contact_equation.hpp"

#include <cmath>
#include <limits>

#include "model/world_hamiltonian.hpp"

namespace brachisto {

namespace {

/// ∂𝓗/∂β with its derivatives by β and θ.
struct AtSlope {
  double value, by_beta, by_theta;
};

/// At B, where p_w = 0: of the world losses alone matter.
AtSlope at_slope(const Scene& scene, const RollingState& state,
                 const Costates& p, double beta) {
  if (scene.world.losses.any()) {
    constexpr int kTheta = 2;
    const double inverse_radius =
        scene.body.rolls() ? 1.0 / scene.body.radius : 0.0;
    const PhaseJet h = hamiltonian_jet(
        scene, inverse_radius,
        {0.0, 0.0, state.theta, state.w, p.p_x, p.p_z, 0.0, 0.0, beta});
    return {h.gradient[kPhaseBeta],
            h.hessian[PhaseJet::pair(kPhaseBeta, kPhaseBeta)],
            h.hessian[PhaseJet::pair(kPhaseBeta, kTheta)]};
  }
  const SlopeHamiltonian h =
      slope_hamiltonian(scene.body, scene.gravity, state, p, beta);
  // ∂²√A/∂β∂θ = −∂²√A/∂β²
  const double along =
      state.w * (p.p_x * std::cos(beta) + p.p_z * std::sin(beta));
  return {h.d_beta, h.d2_beta, -(h.d2_beta + along)};
}

}  // namespace

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
  const AtSlope h = at_slope(problem_.scene(), end->state, p, phi_);
  const double cos_phi = std::cos(phi_);
  const double sin_phi = std::sin(phi_);
  const double by_w = p.p_z * cos_phi - p.p_x * sin_phi;
  at_.residual = h.value;
  at_.by_parameter = h.by_beta;
  const auto fill = [&](const std::vector<Transcription::End::Rate>& rates,
                        nlp::SparseVector& out) {
    out.index.clear();
    out.value.clear();
    for (const auto& rate : rates) {
      out.index.push_back(rate.index);
      out.value.push_back(w * (rate.p_z * cos_phi - rate.p_x * sin_phi) /
                              end->divisor +
                          (by_w * rate.w + h.by_theta * rate.theta));
    }
  };
  fill(end->by_x, at_.by_x);
  fill(end->by_lambda, at_.by_lambda);
  return at_;
}

}  // namespace brachisto
