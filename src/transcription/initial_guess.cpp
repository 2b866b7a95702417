// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/initial_guess.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "brachisto/math/index.hpp"
#include "math/portable_random.hpp"
#include "model/inertia.hpp"
#include "transcription/limited_curve.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

PrimalDual without_multipliers(const PrimalDual& point) {
  return {point.x, {}};
}

/// θ once the centre has come the length s.
double theta_after(const Body& body, double s) {
  return body.rolls() ? body.theta_m + s / body.radius : body.theta_m;
}

/// Where `problem` fixes the centre at the first or last node.
Point fixed_centre(const Transcription& problem, int node) {
  using enum StateComponent;
  const auto bound = [&](StateComponent component) {
    return problem.variable_range(problem.layout().state(node, component))
        .lower;
  };
  return {bound(X), bound(Z)};
}

/// A place of the arc, moved and stretched to run between other end points:
/// these differ by a shift that grows from one end to the other.
Point between(Point start, Point end, const CycloidArc& arc, double sigma) {
  const Point from = arc.at(0.0);
  const Point to = arc.at(arc.psi_end);
  Point out = arc.at(sigma * arc.psi_end);
  out.x += (1.0 - sigma) * (start.x - from.x) + sigma * (end.x - to.x);
  out.z += (1.0 - sigma) * (start.z - from.z) + sigma * (end.z - to.z);
  return out;
}

}  // namespace

PrimalDual cycloid_guess(const RollingTime& problem, const CycloidArc& arc) {
  return without_multipliers(cycloid_extremal(problem, arc));
}

PrimalDual cycloid_guess(const LimitedTime& problem, const CycloidArc& arc) {
  const Body& body = problem.scene().body;
  const double g = problem.scene().gravity;
  const bool moves = problem.free_contacts();
  const Point start = moves ? arc.at(0.0) : fixed_centre(problem, 0);
  const Point end = moves ? arc.at(arc.psi_end)
                          : fixed_centre(problem, problem.mesh().num_points());
  // β falls by half of what ψ grows.
  const double rate = -0.5 * std::sqrt(g / arc.a);
  return without_multipliers(
      sample_at_mesh(problem, arc.rolling_time(g), [&](double sigma) {
        const double psi = sigma * arc.psi_end;
        const Point centre = between(start, end, arc, sigma);
        LimitedPoint point;
        point.state = {centre.x,
                       centre.z,
                       theta_after(body, arc.arc_length(psi)),
                       arc.fall_speed(g, psi),
                       arc.slope_angle(psi),
                       rate};
        point.multipliers.assign(problem.limits().size(), 0.0);
        return point;
      }));
}

PrimalDual cycloid_extremal(const RollingTime& problem, const CycloidArc& arc) {
  const Body& body = problem.scene().body;
  const double g = problem.scene().gravity;
  const Point start = fixed_centre(problem, 0);
  const Point end = fixed_centre(problem, problem.mesh().num_points());
  const double root = std::sqrt(axisymmetric_inertia_factor(body));
  const double w_end = arc.fall_speed(g, arc.psi_end);
  const double phi = arc.slope_angle(arc.psi_end);
  const double p_x = -root * std::cos(phi) / w_end;
  const double p_z = -root * std::sin(phi) / w_end;
  return sample_at_mesh(problem, arc.rolling_time(g), [&](double sigma) {
    const double psi = sigma * arc.psi_end;
    ExtremalPoint point;
    point.centre = between(start, end, arc, sigma);
    point.theta = theta_after(body, arc.arc_length(psi));
    point.w = arc.fall_speed(g, psi);
    point.beta = arc.slope_angle(psi);
    point.p = {p_x, p_z, 0.0,
               (-root * std::sin(point.beta) - point.w * p_z) / g};
    return point;
  });
}

PrimalDual straight_guess(const RollingTime& problem) {
  const Point start = fixed_centre(problem, 0);
  const Point end = fixed_centre(problem, problem.mesh().num_points());
  const double length = distance(end, start);
  const double beta = std::atan2(end.z - start.z, end.x - start.x);
  // On an incline dw/du = g sin β is constant; a level or rising line gets the
  // acceleration of a gentle slope instead, so that the body moves at all.
  const double acceleration =
      problem.scene().gravity * std::max(std::sin(beta), 0.1);
  const double U = std::sqrt(2.0 * length / acceleration);
  const auto on_line = [&](double sigma) {
    const double s = length * sigma * sigma;
    ExtremalPoint point;
    point.centre = {start.x + s * std::cos(beta), start.z + s * std::sin(beta)};
    point.theta = theta_after(problem.scene().body, s);
    point.w = acceleration * U * sigma;
    point.beta = beta;
    return point;
  };
  return without_multipliers(sample_at_mesh(problem, U, on_line));
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
