// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/transcription/initial_guess.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "brachisto/model/inertia.hpp"
#include "math/index.hpp"
#include "math/portable_random.hpp"

namespace brachisto {

namespace {

/// A guess as functions of σ.
struct GuessPoint {
  Point centre;
  double s, w, beta;
};

PrimalDual sample(const RollingTime& problem, double U,
                  const std::function<GuessPoint(double)>& guess) {
  using enum StateComponent;
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const Body& body = problem.scene().body;
  PrimalDual out;
  out.x.resize(at(layout.num_variables()));
  for (int n = 0; n < mesh.num_nodes(); ++n) {
    const int e = std::min(n / mesh.degree, mesh.num_elements() - 1);
    const double t = problem.scheme().nodes.nodes()[at(n - e * mesh.degree)];
    const GuessPoint point = guess(mesh.boundaries[at(e)] + t * mesh.length(e));
    out.x[at(layout.state(n, X))] = point.centre.x;
    out.x[at(layout.state(n, Z))] = point.centre.z;
    out.x[at(layout.state(n, W))] = point.w;
    if (layout.has_theta()) {
      out.x[at(layout.state(n, Theta))] = body.theta_m + point.s / body.radius;
    }
  }
  for (int c = 0; c < mesh.num_points(); ++c) {
    const int e = c / mesh.degree;
    const double t = problem.scheme().rule.points[at(c % mesh.degree)];
    out.x[at(layout.beta(c))] =
        guess(mesh.boundaries[at(e)] + t * mesh.length(e)).beta;
  }
  out.x[at(layout.rolling_time())] = U;
  return out;
}

/// Where `problem` fixes a component of the first or last node.
Point fixed_centre(const RollingTime& problem, int node) {
  using enum StateComponent;
  const auto bound = [&](StateComponent component) {
    return problem.lower()[static_cast<std::size_t>(
        problem.layout().state(node, component))];
  };
  return {bound(X), bound(Z)};
}

}  // namespace

PrimalDual cycloid_guess(const RollingTime& problem, const CycloidArc& arc) {
  const double g = problem.scene().gravity;
  const Point from = arc.at(0.0);
  const Point to = arc.at(arc.psi_end);
  const Point start = fixed_centre(problem, 0);
  const Point end = fixed_centre(problem, problem.mesh().num_points());
  return sample(problem, arc.rolling_time(g), [&](double sigma) {
    const double psi = sigma * arc.psi_end;
    Point centre = arc.at(psi);
    // The ends differ by a shift that grows from one end to the other.
    centre.x += (1.0 - sigma) * (start.x - from.x) + sigma * (end.x - to.x);
    centre.z += (1.0 - sigma) * (start.z - from.z) + sigma * (end.z - to.z);
    return GuessPoint{centre, arc.arc_length(psi), arc.fall_speed(g, psi),
                      arc.slope_angle(psi)};
  });
}

PrimalDual cycloid_extremal(const RollingTime& problem, const CycloidArc& arc) {
  using enum StateComponent;
  PrimalDual out = cycloid_guess(problem, arc);
  const VariableLayout& layout = problem.layout();
  const Mesh& mesh = problem.mesh();
  const double g = problem.scene().gravity;
  const double root =
      std::sqrt(axisymmetric_inertia_factor(problem.scene().body));
  const double w_end = arc.fall_speed(g, arc.psi_end);
  const double phi = arc.slope_angle(arc.psi_end);
  const double p_x = -root * std::cos(phi) / w_end;
  const double p_z = -root * std::sin(phi) / w_end;
  out.lambda.assign(at(layout.num_constraints()), 0.0);
  for (int c = 0; c < mesh.num_points(); ++c) {
    const int e = c / mesh.degree;
    const std::size_t j = at(c % mesh.degree);
    const double t = problem.scheme().rule.points[j];
    const double psi =
        arc.psi_end * (mesh.boundaries[at(e)] + t * mesh.length(e));
    const double p_w = (-root * std::sin(arc.slope_angle(psi)) -
                        arc.fall_speed(g, psi) * p_z) /
                       g;
    const double b = problem.scheme().rule.weights[j];
    out.lambda[at(layout.defect(c, X))] = -b * p_x;
    out.lambda[at(layout.defect(c, Z))] = -b * p_z;
    out.lambda[at(layout.defect(c, W))] = -b * p_w;
  }
  return out;
}

PrimalDual straight_guess(const RollingTime& problem) {
  const Point start = fixed_centre(problem, 0);
  const Point end = fixed_centre(problem, problem.mesh().num_points());
  const double length = std::hypot(end.x - start.x, end.z - start.z);
  const double beta = std::atan2(end.z - start.z, end.x - start.x);
  // On an incline dw/du = g sin β is constant; a level or rising line gets the
  // acceleration of a gentle slope instead, so that the body moves at all.
  const double acceleration =
      problem.scene().gravity * std::max(std::sin(beta), 0.1);
  const double U = std::sqrt(2.0 * length / acceleration);
  return sample(problem, U, [&](double sigma) {
    const double s = length * sigma * sigma;
    return GuessPoint{
        {start.x + s * std::cos(beta), start.z + s * std::sin(beta)},
        s,
        acceleration * U * sigma,
        beta};
  });
}

PrimalDual random_guess(const RollingTime& problem, const CycloidArc& arc,
                        std::uint64_t seed) {
  using enum StateComponent;
  PrimalDual out = cycloid_guess(problem, arc);
  SplitMix64 random(seed);
  const VariableLayout& layout = problem.layout();
  for (int c = 0; c < layout.num_points(); ++c) {
    out.x[at(layout.beta(c))] += random.uniform() - 0.5;
    out.x[at(layout.state(c + 1, W))] *= 0.5 + random.uniform();
  }
  return out;
}

}  // namespace brachisto
