// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/prolongation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "math/roots.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

/// Where the centre has come the length s.
ExtremalPoint at_length(const ExtremalCurve& curve, double s) {
  return curve.at(math::find_root(
      [&](double sigma) { return curve.without_slope(sigma).s - s; }, 0.0, 1.0,
      -s, curve.arc_length() - s));
}

/// The end of the path is given, θ and S belong together, and the multipliers
/// are those of the costates at the end.
PrimalDual completed(ArcLength& problem, std::vector<double> x, double S,
                     const Costates& p) {
  const VariableLayout& layout = problem.layout();
  const int last = layout.state(problem.num_intervals(), X);
  for (const int i : {last, last + 1})
    x[at(i)] = problem.variable_range(i).lower;
  x[at(layout.arc_length())] = S;
  const double turns = S / problem.scene().body.radius;
  for (int node = 1; layout.has_theta() && node < layout.num_nodes(); ++node) {
    check_stop(node);
    x[at(layout.state(node, Theta))] =
        turns * problem.sigma(node) * problem.sigma(node);
  }
  PrimalDual out{std::move(x), {}};
  // A start that is refused is refused again by the solver, which says why.
  if (problem.set_point(out.x)) {
    out.lambda = problem.multipliers(p.p_x, p.p_z);
  } else {
    out.lambda.assign(at(problem.num_constraints()), 0.0);
  }
  return out;
}

/// From the start.
struct Offset {
  double x, z;

  friend Offset operator+(Offset a, Offset b) { return {a.x + b.x, a.z + b.z}; }
  friend Offset operator-(Offset a, Offset b) { return {a.x - b.x, a.z - b.z}; }
  friend Offset operator*(double factor, Offset a) {
    return {factor * a.x, factor * a.z};
  }
};

/// The path through the nodes of straight pieces. With a the direction in which
/// it leaves the start it is S a σ² + b σ³, and b is what is interpolated.
///
/// The first nodes lie beside the path: number j has b off by a term that falls
/// like 1/j² and depends on j alone, whatever the number of pieces. So the path
/// next to the start goes through nodes further away, and what the first ones
/// are off by goes over to the first ones of another mesh.
class CurveThroughNodes {
 public:
  CurveThroughNodes(const ArcLength& problem, std::span<const double> x)
      : problem_(problem),
        x_(x),
        // So that the cubic's error is about that of the pieces themselves.
        stride_(std::clamp(problem.num_intervals() / 128, 1, 16)) {
    const double beta = start_angle(problem.scene().body);
    const double S = x[at(problem.layout().arc_length())];
    along_start_ = {S * std::cos(beta), S * std::sin(beta)};
  }

  /// Where another mesh has its node number `node`, at σ.
  [[nodiscard]] Offset at_node(int node, double sigma) const {
    Offset b = interpolated(sigma * problem_.num_intervals());
    if (node < kPoints * stride_ && node <= problem_.num_intervals()) {
      b = b + (of_node(node) - interpolated(node));
    }
    return sigma * sigma * (along_start_ + sigma * b);
  }

 private:
  static constexpr int kPoints = 4;

  [[nodiscard]] Offset of_node(int node) const {
    const std::size_t i = at(problem_.layout().state(node, X));
    const double sigma = problem_.sigma(node);
    return (1.0 / sigma) *
           (1.0 / (sigma * sigma) * Offset{x_[i], x_[i + 1]} - along_start_);
  }
  /// By a cubic.
  /// \param place  among the nodes
  [[nodiscard]] Offset interpolated(double place) const {
    static const math::LagrangeBasis cubics({0.0, 1.0, 2.0, 3.0});
    const bool at_start = place <= kPoints * stride_;
    const int stride = at_start ? stride_ : 1;
    const int first = at_start ? stride_
                               : std::clamp(static_cast<int>(place) - 1, 1,
                                            problem_.num_intervals() - 3);
    std::array<double, kPoints> weights{};
    cubics.evaluate((place - first) / stride, weights);
    Offset out{};
    for (int i = 0; i < kPoints; ++i) {
      out = out + weights[at(i)] * of_node(first + i * stride);
    }
    return out;
  }

  const ArcLength& problem_;
  std::span<const double> x_;
  int stride_;
  Offset along_start_{};
};

/// \param state     at σ of a node, where β does not matter
/// \param extremal  at σ of a collocation point
template <class State, class Extremal>
PrimalDual sampled(const RollingTime& problem, double rolling_time,
                   const State& state, const Extremal& extremal) {
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const CollocationScheme& scheme = problem.scheme();
  PrimalDual out{std::vector<double>(at(layout.num_variables())),
                 std::vector<double>(at(layout.num_constraints()))};

  for (int n = 0; n < mesh.num_nodes(); ++n) {
    check_stop(n);
    const int e = std::min(n / mesh.degree, mesh.num_elements() - 1);
    const double t = scheme.nodes.nodes()[at(n - e * mesh.degree)];
    const ExtremalPoint point = state(mesh.sigma(e, t));
    out.x[at(layout.state(n, X))] = point.centre.x;
    out.x[at(layout.state(n, Z))] = point.centre.z;
    out.x[at(layout.state(n, W))] = point.w;
    if (layout.has_theta()) out.x[at(layout.state(n, Theta))] = point.theta;
  }
  for (int c = 0; c < mesh.num_points(); ++c) {
    check_stop(c);
    const int e = c / mesh.degree;
    const int j = c % mesh.degree;
    const ExtremalPoint point =
        extremal(mesh.sigma(e, scheme.rule.points[at(j)]));
    const double weight = scheme.rule.weights[at(j)];
    out.x[at(layout.beta(c))] = point.beta;
    out.lambda[at(layout.defect(c, X))] = -weight * point.p.p_x;
    out.lambda[at(layout.defect(c, Z))] = -weight * point.p.p_z;
    out.lambda[at(layout.defect(c, W))] = -weight * point.p.p_w;
    if (layout.has_theta()) {
      out.lambda[at(layout.defect(c, Theta))] = -weight * point.p.p_theta;
    }
  }
  out.x[at(layout.rolling_time())] = rolling_time;
  return out;
}

}  // namespace

PrimalDual prolong(const ExtremalCurve& curve, const RollingTime& problem) {
  return sampled(
      problem, curve.rolling_time(),
      [&](double sigma) { return curve.without_slope(sigma); },
      [&](double sigma) {
        ExtremalPoint point = curve.at(sigma);
        if (!std::isfinite(point.beta)) {
          point.beta = curve.interpolated_slope(sigma);
        }
        return point;
      });
}

PrimalDual sample_at_mesh(
    const RollingTime& problem, double rolling_time,
    const std::function<ExtremalPoint(double sigma)>& extremal) {
  return sampled(problem, rolling_time, extremal, extremal);
}

PrimalDual prolong(const ExtremalCurve& curve, ArcLength& problem) {
  const VariableLayout& layout = problem.layout();
  const Point start = start_of_centre(problem.scene());
  const double S = curve.arc_length();
  std::vector<double> x(at(layout.num_variables()));
  for (int node = 1; node < problem.num_intervals(); ++node) {
    check_stop(node);
    const double sigma = problem.sigma(node);
    const ExtremalPoint point = at_length(curve, S * sigma * sigma);
    x[at(layout.state(node, X))] = point.centre.x - start.x;
    x[at(layout.state(node, Z))] = point.centre.z - start.z;
  }
  return completed(problem, std::move(x), S,
                   {.p_x = curve.p_x(), .p_z = curve.p_z()});
}

PrimalDual prolong(ArcLength& coarse, const PrimalDual& solution,
                   ArcLength& fine) {
  const CurveThroughNodes curve(coarse, solution.x);
  std::vector<double> x(at(fine.num_variables()));
  for (int node = 1; node < fine.num_intervals(); ++node) {
    check_stop(node);
    const double sigma = fine.sigma(node);
    const Offset place = curve.at_node(node, sigma);
    const std::size_t own = at(fine.layout().state(node, X));
    x[own] = place.x;
    x[own + 1] = place.z;
  }
  const Costates p = coarse.set_point(solution.x)
                         ? coarse.end_costates(solution.lambda)
                         : Costates{};
  return completed(fine, std::move(x),
                   solution.x[at(coarse.layout().arc_length())], p);
}

}  // namespace brachisto
