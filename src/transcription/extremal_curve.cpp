// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/extremal_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brachisto/math/stop_condition.hpp"
#include "math/gauss.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at_index(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<double> nodal(const RollingTime& problem, const PrimalDual& point,
                          StateComponent component) {
  std::vector<double> values;
  values.reserve(at_index(problem.mesh().num_nodes()));
  for (int n = 0; n < problem.mesh().num_nodes(); ++n) {
    values.push_back(point.x[at_index(problem.layout().state(n, component))]);
  }
  return values;
}

}  // namespace

ExtremalCurve::ExtremalCurve(const RollingTime& problem,
                             const PrimalDual& point)
    : scene_(problem.scene()),
      mesh_(problem.mesh()),
      scheme_(&problem.scheme()),
      U_(point.x[at_index(problem.layout().rolling_time())]),
      nodes_{nodal(problem, point, X),
             nodal(problem, point, Z),
             {},
             nodal(problem, point, W),
             std::vector<double>(at_index(mesh_.num_nodes())),
             std::vector<double>(at_index(mesh_.num_nodes()))},
      costates_(costates(problem, point.x, point.lambda)) {
  const int p = mesh_.degree;
  const Body& body = scene_.body;
  const bool has_theta = problem.layout().has_theta();
  if (has_theta) nodes_.theta = nodal(problem, point, Theta);

  constexpr double kTurn = 2.0 * std::numbers::pi;
  double neighbour = start_angle(scene_);
  std::vector<double> ds(at_index(p));
  std::vector<double> dt(at_index(p));
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    check_stop(e);
    for (int j = 0; j < p; ++j) {
      const double raw = point.x[at_index(problem.layout().beta(e * p + j))];
      const double beta = raw - kTurn * std::round((raw - neighbour) / kTurn);
      beta_points_.push_back(beta);
      neighbour = beta;

      double w = 0.0;
      double theta = 0.0;
      for (int n = 0; n <= p; ++n) {
        const double weight = scheme_->interpolation(j, n);
        w += weight * nodes_.w[at_index(e * p + n)];
        if (has_theta) theta += weight * nodes_.theta[at_index(e * p + n)];
      }
      w_points_.push_back(w);
      const double hU = mesh_.length(e) * U_;
      ds[at_index(j)] = hU * w;
      dt[at_index(j)] =
          hU * std::sqrt(has_theta ? inertia_factor(body, theta, beta)
                                   : axisymmetric_inertia_factor(body));
    }
    for (int n = 1; n <= p; ++n) {
      const std::size_t node = at_index(e * p + n);
      const std::size_t first = at_index(e * p);
      nodes_.s[node] = nodes_.s[first];
      nodes_.t[node] = nodes_.t[first];
      for (int j = 0; j < p; ++j) {
        nodes_.s[node] += scheme_->integral(n, j) * ds[at_index(j)];
        nodes_.t[node] += scheme_->integral(n, j) * dt[at_index(j)];
      }
    }
  }
  if (scene_.world.sphere) find_sides();
}

void ExtremalCurve::find_sides() {
  for (const SphereSide side : {SphereSide::Inside, SphereSide::Outside}) {
    sides_.push_back(scene_);
    sides_.back().world.side = side;
  }
  const auto side_at = [&](int e, double t) {
    const ExtremalPoint there = at(e, t);
    return side_of_surface(scene_,
                           mass_centre(scene_.body, there.centre, there.theta));
  };
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    std::optional<SphereSide> common;
    bool same = true;
    for (const double t : scheme_->points.nodes()) {
      const SphereSide side = side_at(e, t);
      same = same && side == common.value_or(side);
      common = side;
    }
    side_.push_back(same ? common : std::nullopt);
  }
}

const Scene& ExtremalCurve::scene_in(int element) const {
  if (side_.empty() || !side_[at_index(element)]) return scene_;
  return sides_[*side_[at_index(element)] == SphereSide::Inside ? 0 : 1];
}

ExtremalPoint ExtremalCurve::at(int element, double t) const {
  const int p = mesh_.degree;
  const std::size_t first = at_index(element * p);
  std::array<double, kLargestDegree + 1> storage{};
  const std::span<double> basis(storage.data(), at_index(p + 1));
  scheme_->nodes.evaluate(t, basis);
  const auto value = [&](const std::vector<double>& nodes) {
    double sum = 0.0;
    for (std::size_t n = 0; n < basis.size(); ++n) {
      sum += basis[n] * nodes[first + n];
    }
    return sum;
  };

  ExtremalPoint point;
  point.centre = {value(nodes_.x), value(nodes_.z)};
  point.w = value(nodes_.w);
  point.s = value(nodes_.s);
  point.t = value(nodes_.t);
  point.p = {costates_.p_x, costates_.p_z, 0.0, value(costates_.p_w_nodes)};
  if (!costates_.p_x_nodes.empty()) {
    point.p.p_x = value(costates_.p_x_nodes);
    point.p.p_z = value(costates_.p_z_nodes);
  }
  if (!nodes_.theta.empty()) {
    point.theta = value(nodes_.theta);
    point.p.p_theta = value(costates_.p_theta_nodes);
  } else if (scene_.body.rolls()) {
    point.theta = scene_.body.theta_m + point.s / scene_.body.radius;
  }

  point.beta = minimising_slope(scene_, point.state(), point.p,
                                interpolated_slope(element, t));
  return point;
}

double ExtremalCurve::interpolated_slope(int element, double t) const {
  std::array<double, kLargestDegree> storage{};
  const std::span<double> basis(storage.data(), at_index(mesh_.degree));
  scheme_->points.evaluate(t, basis);
  double slope = 0.0;
  for (std::size_t j = 0; j < basis.size(); ++j) {
    slope += basis[j] * beta_points_[at_index(element * mesh_.degree) + j];
  }
  return slope;
}

ExtremalPoint ExtremalCurve::at(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return at(element, t);
}

double ExtremalCurve::interpolated_slope(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return interpolated_slope(element, t);
}

ExtremalPoint ExtremalCurve::at_node(int node) const {
  const int e = std::min(node / mesh_.degree, mesh_.num_elements() - 1);
  return at(e, scheme_->nodes.nodes()[at_index(node - e * mesh_.degree)]);
}

namespace {

/// ∫ 𝓗 over an element divided by its length, by the given rule.
double mean_hamiltonian(const ExtremalCurve& curve, int element,
                        const math::QuadratureRule& rule) {
  const Scene& scene = curve.scene();
  double mean = 0.0;
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const ExtremalPoint at = curve.at(element, rule.points[i]);
    mean += rule.weights[i] * hamiltonian(scene, at.state(), at.p, at.beta);
  }
  return mean;
}

}  // namespace

std::vector<double> element_errors(const ExtremalCurve& curve) {
  const Mesh& mesh = curve.mesh();
  // Exact for polynomials of degree 2p + 5, three orders above the error.
  const math::QuadratureRule fine = math::gauss_legendre(mesh.degree + 3);
  const math::QuadratureRule& own = collocation_scheme(mesh.degree).rule;
  std::vector<double> errors;
  errors.reserve(static_cast<std::size_t>(mesh.num_elements()));
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    errors.push_back(
        curve.rolling_time() * mesh.length(e) *
        (mean_hamiltonian(curve, e, fine) - mean_hamiltonian(curve, e, own)));
  }
  return errors;
}

}  // namespace brachisto
