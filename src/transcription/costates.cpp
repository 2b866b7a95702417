// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/costates.hpp"

#include <cmath>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

/// Costate of one component at the collocation points.
std::vector<double> at_points(const RollingTime& problem,
                              std::span<const double> lambda,
                              StateComponent component) {
  const int p = problem.mesh().degree;
  const auto& weights = problem.scheme().rule.weights;
  std::vector<double> values(at(problem.mesh().num_points()));
  for (int c = 0; c < problem.mesh().num_points(); ++c) {
    values[at(c)] =
        -lambda[at(problem.layout().defect(c, component))] / weights[at(c % p)];
  }
  return values;
}

/// Costates of θ and w at the nodes: their rates −∂𝓗/∂θ and −∂𝓗/∂w at the
/// collocation points, integrated backwards from zero at the end.
void integrate_to_nodes(const RollingTime& problem, std::span<const double> x,
                        CostateSolution& solution) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const CollocationScheme& scheme = problem.scheme();
  const Body& body = problem.scene().body;
  const double g = problem.scene().gravity;
  const double U = x[at(layout.rolling_time())];
  const int p = mesh.degree;

  solution.p_w_nodes.assign(at(mesh.num_nodes()), 0.0);
  if (layout.has_theta()) {
    solution.p_theta_nodes.assign(at(mesh.num_nodes()), 0.0);
  }
  std::vector<double> rate_theta(at(p));
  std::vector<double> rate_w(at(p));
  for (int e = mesh.num_elements() - 1; e >= 0; --e) {
    check_stop(e);
    const double hU = mesh.length(e) * U;
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const double beta = x[at(layout.beta(c))];
      double pull =
          solution.p_x * std::cos(beta) + solution.p_z * std::sin(beta);
      if (layout.has_theta()) {
        double theta = 0.0;
        for (int n = 0; n <= p; ++n) {
          theta += scheme.interpolation(j, n) *
                   x[at(layout.state(e * p + n, Theta))];
        }
        const double root = std::sqrt(inertia_factor(body, theta, beta));
        rate_theta[at(j)] = hU * (body.eta_m * std::cos(theta - beta) / root +
                                  solution.p_w_points[at(c)] * g * body.eta_m *
                                      std::sin(theta));
        pull += solution.p_theta_points[at(c)] / body.radius;
      }
      rate_w[at(j)] = -hU * pull;
    }
    const auto integrate = [&](const std::vector<double>& rates,
                               std::vector<double>& nodes) {
      double whole = 0.0;
      for (int j = 0; j < p; ++j) {
        whole += scheme.rule.weights[at(j)] * rates[at(j)];
      }
      const double first = nodes[at((e + 1) * p)] - whole;
      for (int n = 0; n < p; ++n) {
        double part = 0.0;
        for (int j = 0; j < p; ++j)
          part += scheme.integral(n, j) * rates[at(j)];
        nodes[at(e * p + n)] = first + part;
      }
    };
    integrate(rate_w, solution.p_w_nodes);
    if (layout.has_theta()) integrate(rate_theta, solution.p_theta_nodes);
  }
}

}  // namespace

CostateSolution costates(const RollingTime& problem, std::span<const double> x,
                         std::span<const double> lambda) {
  CostateSolution solution;
  const Costates constant = problem.end_costates(lambda);
  solution.p_x = constant.p_x;
  solution.p_z = constant.p_z;
  solution.p_w_points = at_points(problem, lambda, W);
  if (problem.layout().has_theta()) {
    solution.p_theta_points = at_points(problem, lambda, Theta);
  }
  integrate_to_nodes(problem, x, solution);
  return solution;
}

}  // namespace brachisto
