// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/prolongation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

namespace {

using enum StateComponent;

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

/// The σ of `curve`, its share of the rolling time, where the centre has come
/// the length s: by Newton's method, safeguarded by bisection; ds/dσ = U w.
ExtremalPoint at_length(const ExtremalCurve& curve, double s, double& sigma) {
  constexpr int kMostSteps = 60;
  constexpr double kClose = 1e-15;
  double low = 0.0;
  double high = 1.0;
  ExtremalPoint point = curve.at(sigma);
  for (int i = 0; i < kMostSteps; ++i) {
    const double miss = s - point.s;
    (miss > 0.0 ? low : high) = sigma;
    double next = sigma + miss / (curve.rolling_time() * point.w);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const double step = std::abs(next - sigma);
    sigma = next;
    point = curve.at(sigma);
    if (step <= kClose) break;
  }
  return point;
}

/// The end of the path is given, θ and S belong together.
void fix_ends(const ArcLength& problem, std::vector<double>& x, double S) {
  const VariableLayout& layout = problem.layout();
  for (const int i : {layout.state(problem.num_intervals(), X),
                      layout.state(problem.num_intervals(), Z)}) {
    x[at(i)] = problem.lower()[at(i)];
  }
  x[at(layout.arc_length())] = S;
  if (!layout.has_theta()) return;
  const double turns = S / problem.scene().body.radius;
  for (int node = 1; node <= problem.num_intervals(); ++node) {
    check_stop(node);
    x[at(layout.state(node, Theta))] =
        turns * problem.sigma(node) * problem.sigma(node);
  }
}

PrimalDual with_multipliers(ArcLength& problem, std::vector<double> x,
                            double p_x, double p_z) {
  PrimalDual out{std::move(x), {}};
  // A start that is refused is refused again by the solver, which says why.
  if (problem.set_point(out.x)) {
    out.lambda = problem.multipliers(p_x, p_z);
  } else {
    out.lambda.assign(at(problem.num_constraints()), 0.0);
  }
  return out;
}

}  // namespace

PrimalDual prolong(const ExtremalCurve& curve, const RollingTime& problem) {
  return sample_at_mesh(problem, curve.rolling_time(), [&](double sigma) {
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
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const CollocationScheme& scheme = problem.scheme();
  PrimalDual out{std::vector<double>(at(layout.num_variables())),
                 std::vector<double>(at(layout.num_constraints()))};

  for (int n = 0; n < mesh.num_nodes(); ++n) {
    check_stop(n);
    const int e = std::min(n / mesh.degree, mesh.num_elements() - 1);
    const double t = scheme.nodes.nodes()[at(n - e * mesh.degree)];
    const ExtremalPoint point =
        extremal(mesh.boundaries[at(e)] + t * mesh.length(e));
    out.x[at(layout.state(n, X))] = point.centre.x;
    out.x[at(layout.state(n, Z))] = point.centre.z;
    out.x[at(layout.state(n, W))] = point.w;
    if (layout.has_theta()) out.x[at(layout.state(n, Theta))] = point.theta;
  }
  for (int c = 0; c < mesh.num_points(); ++c) {
    check_stop(c);
    const int e = c / mesh.degree;
    const int j = c % mesh.degree;
    const ExtremalPoint point = extremal(
        mesh.boundaries[at(e)] + scheme.rule.points[at(j)] * mesh.length(e));
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

PrimalDual prolong(const ExtremalCurve& curve, ArcLength& problem) {
  const VariableLayout& layout = problem.layout();
  const Point start = start_of_centre(problem.scene());
  const double S = curve.arc_length();
  std::vector<double> x(at(layout.num_variables()));
  for (int node = 1; node < problem.num_intervals(); ++node) {
    check_stop(node);
    const double sigma = problem.sigma(node);
    double place = sigma;
    const ExtremalPoint point = at_length(curve, S * sigma * sigma, place);
    x[at(layout.state(node, X))] = point.centre.x - start.x;
    x[at(layout.state(node, Z))] = point.centre.z - start.z;
  }
  fix_ends(problem, x, S);
  return with_multipliers(problem, std::move(x), curve.p_x(), curve.p_z());
}

PrimalDual prolong(ArcLength& coarse, const PrimalDual& solution,
                   ArcLength& fine) {
  const VariableLayout& from = coarse.layout();
  const VariableLayout& to = fine.layout();
  const int n = coarse.num_intervals();
  std::vector<double> x(at(to.num_variables()));
  for (int node = 1; node < fine.num_intervals(); ++node) {
    check_stop(node);
    // Place among the nodes of the coarse mesh, and the first of the four next
    // to it; the start, where x/σ² has no value, is not among them.
    const double t = fine.sigma(node) * n;
    const int first = std::clamp(static_cast<int>(t) - 1, 1, n - 3);
    const double u = t - first;
    const std::array<double, 4> weights{
        -(u - 1.0) * (u - 2.0) * (u - 3.0) / 6.0,
        u * (u - 2.0) * (u - 3.0) / 2.0, -u * (u - 1.0) * (u - 3.0) / 2.0,
        u * (u - 1.0) * (u - 2.0) / 6.0};
    double x_c = 0.0, z_c = 0.0;
    for (int i = 0; i < 4; ++i) {
      const double ratio = t / (first + i);
      const double weight = weights[at(i)] * ratio * ratio;
      x_c += weight * solution.x[at(from.state(first + i, X))];
      z_c += weight * solution.x[at(from.state(first + i, Z))];
    }
    x[at(to.state(node, X))] = x_c;
    x[at(to.state(node, Z))] = z_c;
  }
  fix_ends(fine, x, solution.x[at(from.arc_length())]);
  double p_x = 0.0, p_z = 0.0;
  if (coarse.set_point(solution.x)) {
    const Costates p = coarse.end_costates(solution.lambda);
    p_x = p.p_x;
    p_z = p.p_z;
  }
  return with_multipliers(fine, std::move(x), p_x, p_z);
}

}  // namespace brachisto
