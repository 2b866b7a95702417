// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/contact_equation.hpp"

#include <cmath>

#include "brachisto/model/hamiltonian.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

ContactEquation::ContactEquation(RollingTime& problem) : problem_(problem) {
  const VariableLayout& layout = problem.layout();
  const int last = problem.mesh().num_points();
  fixed_rates_.index = {layout.state(last, X), layout.state(last, Z)};
  fixed_rates_.value = {0.0, 0.0};
  at_.by_x.index = {layout.state(last, W)};
  if (layout.has_theta()) at_.by_x.index.push_back(layout.state(last, Theta));
  at_.by_x.value.resize(at_.by_x.index.size());
  at_.by_lambda.index = {layout.defect(last - 1, X),
                         layout.defect(last - 1, Z)};
  at_.by_lambda.value.resize(2);
}

void ContactEquation::set_parameter(double phi) {
  phi_ = phi;
  problem_.set_end_angle(phi);
  // C_B = (L + r sin φ, H − r cos φ)
  const double r = problem_.scene().body.radius;
  fixed_rates_.value = {r * std::cos(phi), r * std::sin(phi)};
}

const nlp::ClosingEquation::Linearisation& ContactEquation::linearise(
    std::span<const double> x, std::span<const double> lambda) {
  const VariableLayout& layout = problem_.layout();
  const int last = problem_.mesh().num_points();
  const Body& body = problem_.scene().body;
  RollingState end;
  end.w = x[at(layout.state(last, W))];
  if (layout.has_theta()) end.theta = x[at(layout.state(last, Theta))];
  const double b = problem_.scheme().rule.weights.back();
  const Costates p{.p_x = -lambda[at(layout.defect(last - 1, X))] / b,
                   .p_z = -lambda[at(layout.defect(last - 1, Z))] / b};
  const SlopeHamiltonian h =
      slope_hamiltonian(body, problem_.scene().gravity, end, p, phi_);
  const double cos_phi = std::cos(phi_);
  const double sin_phi = std::sin(phi_);
  at_.residual = h.d_beta;
  at_.by_parameter = h.d2_beta;
  at_.by_x.value[0] = p.p_z * cos_phi - p.p_x * sin_phi;
  if (layout.has_theta()) {
    // ∂²√A/∂β∂θ = −∂²√A/∂β²
    const double along = end.w * (p.p_x * cos_phi + p.p_z * sin_phi);
    at_.by_x.value[1] = -(h.d2_beta + along);
  }
  at_.by_lambda.value = {end.w * sin_phi / b, -end.w * cos_phi / b};
  return at_;
}

}  // namespace brachisto
