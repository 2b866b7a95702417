// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/prolongation.hpp"

#include <cmath>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

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
  using enum StateComponent;
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
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

}  // namespace brachisto
