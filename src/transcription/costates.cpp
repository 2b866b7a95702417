// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/costates.hpp"

#include <array>
#include <cmath>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/world_hamiltonian.hpp"

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
    integrate_back(scheme, e, rate_w, solution.p_w_nodes);
    if (layout.has_theta()) {
      integrate_back(scheme, e, rate_theta, solution.p_theta_nodes);
    }
  }
}

/// The same in another world, of x and z too where they are not constant.
void integrate_in_world(const RollingTime& problem, std::span<const double> x,
                        std::span<const double> lambda,
                        CostateSolution& solution) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const Scene& scene = problem.scene();
  const int p = mesh.degree;
  const auto nodes = at(mesh.num_nodes());
  solution.p_w_nodes.assign(nodes, 0.0);
  if (layout.has_theta()) solution.p_theta_nodes.assign(nodes, 0.0);
  const bool constant = !scene.world.sphere;
  std::vector<double> p_x, p_z;
  if (!constant) {
    solution.p_x_nodes.assign(nodes, solution.p_x);
    solution.p_z_nodes.assign(nodes, solution.p_z);
    p_x = at_points(problem, lambda, X);
    p_z = at_points(problem, lambda, Z);
  }
  std::array<std::vector<double>, 4> rates;  // of p_x, p_z, p_θ, p_w
  for (auto& of : rates) of.resize(at(p));
  for (int e = mesh.num_elements() - 1; e >= 0; --e) {
    check_stop(e);
    const double hU = mesh.length(e) * x[at(layout.rolling_time())];
    for (int j = 0; j < p; ++j) {
      const int c = e * p + j;
      const auto state = [&](StateComponent component) {
        double sum = 0.0;
        for (int n = 0; n <= p; ++n) {
          sum += problem.scheme().interpolation(j, n) *
                 x[at(layout.state(e * p + n, component))];
        }
        return sum;
      };
      const Costates here{
          constant ? solution.p_x : p_x[at(c)],
          constant ? solution.p_z : p_z[at(c)],
          layout.has_theta() ? solution.p_theta_points[at(c)] : 0.0,
          solution.p_w_points[at(c)]};
      const Costates rate =
          in_world::costate_rates(scene,
                                  {{state(X), state(Z)},
                                   layout.has_theta() ? state(Theta) : 0.0,
                                   state(W)},
                                  here, x[at(layout.beta(c))]);
      rates[0][at(j)] = hU * rate.p_x;
      rates[1][at(j)] = hU * rate.p_z;
      rates[2][at(j)] = hU * rate.p_theta;
      rates[3][at(j)] = hU * rate.p_w;
    }
    const auto integrate = [&](std::size_t costate, std::vector<double>& out) {
      if (!out.empty()) {
        integrate_back(problem.scheme(), e, rates[costate], out);
      }
    };
    integrate(0, solution.p_x_nodes);
    integrate(1, solution.p_z_nodes);
    integrate(2, solution.p_theta_nodes);
    integrate(3, solution.p_w_nodes);
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
  if (problem.scene().world.changes_rates()) {
    integrate_in_world(problem, x, lambda, solution);
  } else {
    integrate_to_nodes(problem, x, solution);
  }
  return solution;
}

}  // namespace brachisto
