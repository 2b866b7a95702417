// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/extremal_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/polynomial_basis.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"
#include "transcription/costates.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at_index(int i) {
  return static_cast<std::size_t>(i);
}

/// Σ weights[n] nodes[n], each of the values by itself.
template <std::size_t Values>
std::array<double, Values> combined(
    std::span<const double> weights,
    const std::vector<std::array<double, Values>>& nodes, int first) {
  std::array<double, Values> sum{};
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const std::array<double, Values>& node = nodes[at_index(first) + n];
    for (std::size_t i = 0; i < Values; ++i) sum[i] += weights[n] * node[i];
  }
  return sum;
}

/// A basis of `size` polynomials, stored in an array for the largest degree.
template <std::size_t Most>
std::span<double> of_basis(std::array<double, Most>& storage, int size) {
  return std::span(storage).first(at_index(size));
}
template <std::size_t Most>
std::span<const double> of_basis(const std::array<double, Most>& storage,
                                 int size) {
  return std::span(storage).first(at_index(size));
}

}  // namespace

ElementPlace::ElementPlace(const CollocationScheme& scheme, double place)
    : t(place) {
  scheme.nodes.evaluate(t, of_basis(nodes, scheme.degree + 1),
                        of_basis(slopes, scheme.degree + 1));
  scheme.points.evaluate(t, of_basis(points, scheme.degree));
}

ExtremalCurve::ExtremalCurve(const RollingTime& problem,
                             const PrimalDual& point)
    : scene_(problem.scene()),
      mesh_(problem.mesh()),
      scheme_(&problem.scheme()),
      U_(point.x[at_index(problem.layout().rolling_time())]),
      nodes_(at_index(mesh_.num_nodes())),
      has_theta_(problem.layout().has_theta()) {
  const VariableLayout& layout = problem.layout();
  const int p = mesh_.degree;
  {
    const CostateSolution along = costates(problem, point.x, point.lambda);
    p_x_ = along.p_x;
    p_z_ = along.p_z;
    const auto state = [&](int n, StateComponent component) {
      return point.x[at_index(layout.state(n, component))];
    };
    for (int n = 0; n < mesh_.num_nodes(); ++n) {
      const std::size_t i = at_index(n);
      nodes_[i] = {state(n, X),
                   state(n, Z),
                   has_theta_ ? state(n, Theta) : 0.0,
                   state(n, W),
                   has_theta_ ? along.p_theta_nodes[i] : 0.0,
                   along.p_w_nodes[i],
                   0.0,
                   0.0};
      if (along.p_x_nodes.empty()) continue;
      pulls_.push_back({along.p_x_nodes[i], along.p_z_nodes[i]});
    }
  }

  constexpr double kTurn = 2.0 * std::numbers::pi;
  double neighbour = start_angle(scene_);
  beta_points_.reserve(at_index(mesh_.num_points()));
  w_points_.reserve(at_index(mesh_.num_points()));
  std::array<double, kLargestDegree> ds{}, dt{};
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    check_stop(e);
    const double hU = mesh_.length(e) * U_;
    for (int j = 0; j < p; ++j) {
      const double raw = point.x[at_index(layout.beta(e * p + j))];
      const double beta = raw - kTurn * std::round((raw - neighbour) / kTurn);
      beta_points_.push_back(beta);
      neighbour = beta;

      double w = 0.0;
      double theta = 0.0;
      for (int n = 0; n <= p; ++n) {
        const double weight = scheme_->interpolation(j, n);
        theta += weight * nodes_[at_index(e * p + n)][kTheta];
        w += weight * nodes_[at_index(e * p + n)][kW];
      }
      w_points_.push_back(w);
      ds[at_index(j)] = hU * w;
      dt[at_index(j)] = hU * root_of_inertia(scene_, theta, beta);
    }
    const Node& before = nodes_[at_index(e * p)];
    for (int n = 1; n <= p; ++n) {
      double s = before[kS];
      double t = before[kT];
      for (int j = 0; j < p; ++j) {
        s += scheme_->integral(n, j) * ds[at_index(j)];
        t += scheme_->integral(n, j) * dt[at_index(j)];
      }
      Node& node = nodes_[at_index(e * p + n)];
      node[kS] = s;
      node[kT] = t;
    }
  }
  if (has_surface(scene_.world)) find_sides();
}

void ExtremalCurve::find_sides() {
  for (const FieldSide side : {FieldSide::Inside, FieldSide::Outside}) {
    sides_.push_back(scene_);
    sides_.back().world.side = side;
  }
  const auto side_at = [&](int e, double t) {
    const ExtremalPoint there = without_slope(e, ElementPlace(*scheme_, t));
    return side_of_surface(scene_,
                           mass_centre(scene_.body, there.centre, there.theta));
  };
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    std::optional<FieldSide> common;
    bool same = true;
    for (const double t : scheme_->points.nodes()) {
      const FieldSide side = side_at(e, t);
      same = same && side == common.value_or(side);
      common = side;
    }
    side_.push_back(same ? common : std::nullopt);
  }
}

const Scene& ExtremalCurve::scene_in(int element) const {
  if (side_.empty() || !side_[at_index(element)]) return scene_;
  return sides_[*side_[at_index(element)] == FieldSide::Inside ? 0 : 1];
}

ExtremalPoint ExtremalCurve::without_slope(int element,
                                           const ElementPlace& place) const {
  const int first = element * mesh_.degree;
  const auto weights = of_basis(place.nodes, mesh_.degree + 1);
  const auto [x, z, theta, w, p_theta, p_w, s, t] =
      combined(weights, nodes_, first);
  ExtremalPoint point{{x, z}, theta, w, s, t, {p_x_, p_z_, p_theta, p_w}};
  if (!pulls_.empty()) {
    const auto [p_x, p_z] = combined(weights, pulls_, first);
    point.p.p_x = p_x;
    point.p.p_z = p_z;
  }
  if (!has_theta_ && scene_.body.rolls()) {
    point.theta = scene_.body.theta_m + s / scene_.body.radius;
  }
  return point;
}

ExtremalPoint ExtremalCurve::at(int element, const ElementPlace& place) const {
  ExtremalPoint point = without_slope(element, place);
  point.beta = minimising_slope(scene_, point.state(), point.p,
                                interpolated_slope(element, place));
  return point;
}

double ExtremalCurve::leading_w(int element) const {
  return combined(scheme_->nodes.weights(), nodes_, element * mesh_.degree)[kW];
}

std::array<double, 8> ExtremalCurve::rates(int element,
                                           const ElementPlace& place) const {
  const int first = element * mesh_.degree;
  const auto weights = of_basis(place.slopes, mesh_.degree + 1);
  const auto [x, z, theta, w, p_theta, p_w, s, t] =
      combined(weights, nodes_, first);
  std::array<double, 8> out{x, z, theta, w, 0.0, 0.0, p_theta, p_w};
  if (!pulls_.empty()) {
    const auto [p_x, p_z] = combined(weights, pulls_, first);
    out[4] = p_x;
    out[5] = p_z;
  }
  if (!has_theta_ && scene_.body.rolls()) out[2] = s / scene_.body.radius;
  return out;
}

double ExtremalCurve::interpolated_slope(int element,
                                         const ElementPlace& place) const {
  const double* const slopes =
      beta_points_.data() + at_index(element * mesh_.degree);
  double slope = 0.0;
  for (std::size_t j = 0; j < at_index(mesh_.degree); ++j) {
    slope += place.points[j] * slopes[j];
  }
  return slope;
}

ExtremalPoint ExtremalCurve::at(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return at(element, t);
}

ExtremalPoint ExtremalCurve::without_slope(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return without_slope(element, ElementPlace(*scheme_, t));
}

double ExtremalCurve::interpolated_slope(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return interpolated_slope(element, ElementPlace(*scheme_, t));
}

ExtremalPoint ExtremalCurve::at_node(int node) const {
  const int e = std::min(node / mesh_.degree, mesh_.num_elements() - 1);
  return at(e, scheme_->nodes.nodes()[at_index(node - e * mesh_.degree)]);
}

namespace {

/// A quadrature rule at places of any element.
struct RuleInElements {
  std::vector<ElementPlace> places;
  std::vector<double> weights;

  RuleInElements(const CollocationScheme& scheme,
                 const math::QuadratureRule& rule)
      : weights(rule.weights) {
    for (const double t : rule.points) places.emplace_back(scheme, t);
  }
};

/// ∫ 𝓗 over an element divided by its length, by the given rule.
double mean_hamiltonian(const ExtremalCurve& curve, int element,
                        const RuleInElements& rule) {
  const Scene& scene = curve.scene();
  double mean = 0.0;
  for (std::size_t i = 0; i < rule.weights.size(); ++i) {
    const ExtremalPoint at = curve.at(element, rule.places[i]);
    mean += rule.weights[i] * hamiltonian(scene, at.state(), at.p, at.beta);
  }
  return mean;
}

}  // namespace

std::vector<double> element_errors(const ExtremalCurve& curve) {
  const Mesh& mesh = curve.mesh();
  const CollocationScheme& scheme = gauss_scheme(mesh.degree);
  // Exact for polynomials of degree 2p + 5, three orders above the error.
  const RuleInElements fine(scheme, math::gauss_legendre(mesh.degree + 3));
  const RuleInElements own(scheme, scheme.rule);
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

double sum_of_errors(std::span<const double> element_errors) {
  double sum = 0.0;
  for (const double error : element_errors) sum += std::abs(error);
  return sum;
}

}  // namespace brachisto
