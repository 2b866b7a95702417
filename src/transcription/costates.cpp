// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/costates.hpp"

#include <array>
#include <cstddef>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

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

/// The integral of rates at the collocation points of an element back from its
/// last node.
void integrate_back(const CollocationScheme& scheme, int element,
                    const std::vector<double>& rates,
                    std::vector<double>& nodes) {
  const int p = scheme.degree;
  double whole = 0.0;
  for (int j = 0; j < p; ++j) {
    whole += scheme.rule.weights[at(j)] * rates[at(j)];
  }
  const double first = nodes[at((element + 1) * p)] - whole;
  for (int n = 0; n < p; ++n) {
    double part = 0.0;
    for (int j = 0; j < p; ++j) part += scheme.integral(n, j) * rates[at(j)];
    nodes[at(element * p + n)] = first + part;
  }
}

/// Costates at the nodes: their rates −∂𝓗/∂y at the collocation points,
/// integrated backwards from the end, where those of θ and w are 0. Of x and z
/// only where they are not constant.
void integrate_to_nodes(const RollingTime& problem, std::span<const double> x,
                        std::span<const double> lambda,
                        CostateSolution& solution) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const double U = x[at(layout.rolling_time())];
  const int p = mesh.degree;
  constexpr std::size_t kStates = 4;
  const auto nodes = at(mesh.num_nodes());
  std::array<std::vector<double>, kStates> points{
      std::vector<double>(at(mesh.num_points()), solution.p_x),
      std::vector<double>(at(mesh.num_points()), solution.p_z),
      solution.p_theta_points, solution.p_w_points};
  if (problem.scene().world.field_varies()) {
    points[0] = at_points(problem, lambda, X);
    points[1] = at_points(problem, lambda, Z);
    solution.p_x_nodes.assign(nodes, solution.p_x);
    solution.p_z_nodes.assign(nodes, solution.p_z);
  }
  if (layout.has_theta()) solution.p_theta_nodes.assign(nodes, 0.0);
  solution.p_w_nodes.assign(nodes, 0.0);
  const std::array<std::vector<double>*, kStates> at_nodes{
      &solution.p_x_nodes, &solution.p_z_nodes, &solution.p_theta_nodes,
      &solution.p_w_nodes};
  std::array<std::vector<double>, kStates> rates;
  for (auto& of : rates) of.resize(at(p));
  for (int e = mesh.num_elements() - 1; e >= 0; --e) {
    check_stop(e);
    const double hU = mesh.length(e) * U;
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const auto [cost, states] = problem.rates(x, c);
      for (std::size_t a = 0; a < kStates; ++a) {
        double sum = cost.gradient[a];
        for (std::size_t s = 0; s < kStates; ++s) {
          if (!points[s].empty()) {
            sum += points[s][at(c)] * states[s].gradient[a];
          }
        }
        rates[a][at(j)] = -hU * sum;
      }
    }
    for (std::size_t a = 0; a < kStates; ++a) {
      if (!at_nodes[a]->empty()) {
        integrate_back(problem.scheme(), e, rates[a], *at_nodes[a]);
      }
    }
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
  integrate_to_nodes(problem, x, lambda, solution);
  return solution;
}

}  // namespace brachisto
