// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/limited_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/inertia.hpp"

namespace brachisto {

LimitedMotion::LimitedMotion(LimitedCurve curve, const Scene& scene,
                             const Units& units,
                             std::optional<double> transit_time)
    : curve_(std::move(curve)),
      scene_(scene),
      units_(units),
      transit_time_(transit_time.value_or(curve_.transit_time() * units_.time)),
      rule_(math::gauss_legendre(curve_.problem().mesh().degree + 1)),
      ends_(1) {
  for (int e = 0; e < curve_.problem().mesh().num_elements(); ++e) {
    const Passed more = within(e, 1.0);
    ends_.push_back({ends_.back().t + more.t, ends_.back().s + more.s});
  }
}

LimitedMotion::Passed LimitedMotion::within(int element, double t) const {
  const Body& body = curve_.problem().scene().body;
  const double hU =
      curve_.problem().mesh().length(element) * curve_.rolling_time();
  Passed sum;
  for (std::size_t i = 0; i < rule_.points.size(); ++i) {
    const auto state = curve_.at(element, t * rule_.points[i]).state;
    const double weight = hU * t * rule_.weights[i];
    sum.t += weight * std::sqrt(inertia_factor(body, state.theta, state.beta));
    sum.s += weight * state.w;
  }
  return sum;
}

StartLimits LimitedMotion::at_start() const {
  const LimitedTime& problem = curve_.problem();
  const Scene& natural = problem.scene();
  const TurningPoint<double> first =
      curve_.at(0, problem.scheme().rule.points.front()).state;
  const TurningPoint<double> rest = curve_.at(0, 0.0).state;
  const PathState start{
      {rest.x, rest.z}, natural.body.theta_m, rest.beta, rest.w, rest.q};
  StartLimits out =
      curve_.holds_control(0) && !problem.pushed()
          ? start_limits_of_curvature(natural, start, first.q / first.w)
          : start_limits(natural, start);
  out.normal_force_rate /= units_.time;
  out.curvature /= units_.length;
  return out;
}

TrajectoryPoint LimitedMotion::convert(int element, double t) const {
  const Scene& natural = curve_.problem().scene();
  const TurningPoint<double> state = curve_.at(element, t).state;
  const Passed more = within(element, t);
  TrajectoryPoint out;
  out.sigma = curve_.problem().mesh().sigma(element, t);
  // A body that the problem gives no θ turns all the same.
  const Passed& before = ends_[brachisto::at(element)];
  const double s = before.s + more.s;
  const double theta = natural.body.off_centred() || !natural.body.rolls()
                           ? state.theta
                           : natural.body.theta_m + s / natural.body.radius;
  out.motion = kinematics(
      natural, {{state.x, state.z}, theta, state.beta, state.w, state.q});
  if (out.sigma == 0.0 && natural.world.start_speed == 0.0) {
    // There κ_c = q/w is a limit.
    const StartLimits start = at_start();
    out.motion.kappa_b = start.curvature * units_.length;
    out.motion.fold_margin = start.fold_margin;
  }
  const auto scale = [&](Point& p) {
    p.x *= units_.length;
    p.z *= units_.length;
  };
  out.centre = {state.x, state.z};
  scale(out.centre);
  scale(out.motion.mass_centre);
  scale(out.motion.contact);
  out.motion.v_c *= units_.speed();
  out.motion.omega /= units_.time;
  out.motion.kappa_b /= units_.length;
  out.u = out.sigma * curve_.rolling_time() * units_.time;
  out.t = (before.t + more.t) * units_.time;
  out.s = s * units_.length;
  out.theta = theta + (scene_.body.theta_m - natural.body.theta_m);
  out.beta = state.beta;
  return out;
}

TrajectoryPoint LimitedMotion::at(double sigma) const {
  const auto [element, t] = curve_.problem().mesh().locate(sigma);
  return convert(element, t);
}

std::vector<TrajectoryPoint> LimitedMotion::at_nodes() const {
  std::vector<TrajectoryPoint> rows{convert(0, 0.0)};
  const CollocationScheme& scheme = curve_.problem().scheme();
  for (int e = 0; e < curve_.problem().mesh().num_elements(); ++e) {
    check_stop(e);
    for (const double t : scheme.rule.points) rows.push_back(convert(e, t));
  }
  return rows;
}

std::vector<TrajectoryPoint> LimitedMotion::fine_sample(int least) const {
  const Mesh& mesh = curve_.problem().mesh();
  const int each = std::max(2 * mesh.degree, least / mesh.num_elements() + 1);
  std::vector<TrajectoryPoint> rows{convert(0, 0.0)};
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (int i = 1; i <= each; ++i) {
      rows.push_back(convert(e, static_cast<double>(i) / each));
    }
  }
  return rows;
}

}  // namespace brachisto
