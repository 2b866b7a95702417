// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/arc_contact.hpp"

#include <cmath>
#include <limits>

#include "brachisto/model/hamiltonian.hpp"

namespace brachisto {

namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// θ and w at the end of the current point of `problem`.
RollingState end_state(const ArcLength& problem, std::span<const double> x) {
  const ArcLengthLayout& layout = problem.layout();
  const Body& body = problem.scene().body;
  RollingState end{body.theta_m, problem.end_w()};
  if (layout.has_theta())
    end.theta += x[at(layout.theta(layout.num_intervals()))];
  return end;
}

}  // namespace

double end_slope(ArcLength& problem, std::span<const double> x,
                 std::span<const double> lambda) {
  if (!problem.set_point(x)) return std::numeric_limits<double>::quiet_NaN();
  const ArcLengthLayout& layout = problem.layout();
  const int last = layout.num_intervals();
  const ArcLength::EndCostates p = problem.end_costates(lambda);
  const double dx = x[at(layout.x(last))] - x[at(layout.x(last - 1))];
  const double dz = x[at(layout.z(last))] - x[at(layout.z(last - 1))];
  return minimising_slope(
      problem.scene().body, problem.scene().gravity, end_state(problem, x),
      {.p_x = p.x.value, .p_z = p.z.value}, std::atan2(dz, dx));
}

ArcContactEquation::ArcContactEquation(ArcLength& problem) : problem_(problem) {
  const ArcLengthLayout& layout = problem.layout();
  const int last = layout.num_intervals();
  fixed_rates_.index = {layout.x(last), layout.z(last)};
  fixed_rates_.value = {0.0, 0.0};
  for (const int node : {last, last - 1}) {
    for (int i = 0; i < layout.variables_per_node(); ++i) {
      at_.by_x.index.push_back(layout.x(node) + i);
    }
  }
  at_.by_x.index.push_back(layout.arc_length());
  at_.by_x.value.resize(at_.by_x.index.size());
  at_.by_lambda.index = {layout.no_slip(last)};
  at_.by_lambda.value.resize(1);
}

void ArcContactEquation::set_parameter(double phi) {
  phi_ = phi;
  problem_.set_end_angle(phi);
  // C_B = (L + r sin φ, H − r cos φ)
  const double r = problem_.scene().body.radius;
  fixed_rates_.value = {r * std::cos(phi), r * std::sin(phi)};
}

const nlp::ClosingEquation::Linearisation& ArcContactEquation::linearise(
    std::span<const double> x, std::span<const double> lambda) {
  if (!problem_.set_point(x)) {
    at_.residual = std::numeric_limits<double>::quiet_NaN();
    return at_;
  }
  const auto per_node =
      static_cast<std::size_t>(problem_.layout().variables_per_node());
  const ArcLength::EndCostates costates = problem_.end_costates(lambda);
  const Costates p{.p_x = costates.x.value, .p_z = costates.z.value};
  const RollingState end = end_state(problem_, x);
  const SlopeHamiltonian h = slope_hamiltonian(
      problem_.scene().body, problem_.scene().gravity, end, p, phi_);
  const double cos_phi = std::cos(phi_);
  const double sin_phi = std::sin(phi_);
  const auto of_costates = [&](double p_x, double p_z) {
    return end.w * (p_z * cos_phi - p_x * sin_phi);
  };
  at_.residual = h.d_beta;
  at_.by_parameter = h.d2_beta;
  const auto& [x_c, z_c] = costates;
  for (std::size_t i = 0; i < per_node; ++i) {
    at_.by_x.value[i] = of_costates(x_c.by_last[i], z_c.by_last[i]);
    at_.by_x.value[per_node + i] =
        of_costates(x_c.by_before[i], z_c.by_before[i]);
  }
  const double by_w = p.p_z * cos_phi - p.p_x * sin_phi;
  const auto [w_z, w_theta] = problem_.end_w_slopes();
  at_.by_x.value[1] += by_w * w_z;
  if (problem_.layout().has_theta()) {
    // ∂²√A/∂β∂θ = −∂²√A/∂β²
    const double along = end.w * (p.p_x * cos_phi + p.p_z * sin_phi);
    at_.by_x.value[2] += by_w * w_theta - (h.d2_beta + along);
  }
  at_.by_x.value.back() = of_costates(x_c.by_S, z_c.by_S);
  at_.by_lambda.value[0] = of_costates(x_c.by_no_slip, z_c.by_no_slip);
  return at_;
}

}  // namespace brachisto
