// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "model/field.hpp"
#include "model/path_inequality.hpp"
#include "model/start_angle.hpp"
#include "transcription/held_control.hpp"

namespace brachisto {

// ---- What all have in common.

MeshMotion::MeshMotion(const Scene& natural, const Mesh& mesh,
                       std::span<const double> nodes, double rolling_time,
                       const Scene& scene, const Units& units,
                       double transit_time)
    : natural_(natural),
      mesh_(mesh),
      nodes_(nodes.begin(), nodes.end()),
      rolling_time_(rolling_time),
      scene_(scene),
      units_(units),
      transit_time_(transit_time) {}

StartLimits MeshMotion::at_start() const {
  StartLimits out = limits_at_start();
  out.normal_force_rate /= units_.time;
  out.curvature /= units_.length;
  return out;
}

StartLimits MeshMotion::limits_at_start() const {
  PathState start = place(0, 0.0).state;
  start.beta = start_angle();
  return start_limits(natural(), start);
}

TrajectoryPoint MeshMotion::row(int element, double t, double sigma) const {
  const auto [state, time, s] = place(element, t);
  TrajectoryPoint out;
  out.sigma = sigma;
  out.motion = kinematics(natural_, state);
  if (sigma == 0.0 && natural_.world.start_speed == 0.0) {
    // There κ_c = β_u/w is a limit.
    const StartLimits start = limits_at_start();
    out.motion.kappa_b = start.curvature;
    out.motion.fold_margin = start.fold_margin;
  }
  out.centre = state.centre;
  for (Point* p : {&out.centre, &out.motion.mass_centre, &out.motion.contact}) {
    p->x *= units_.length;
    p->z *= units_.length;
  }
  out.motion.v_c *= units_.speed();
  out.motion.omega /= units_.time;
  out.motion.kappa_b /= units_.length;
  out.u = sigma * rolling_time_ * units_.time;
  out.t = time * units_.time;
  out.s = s * units_.length;
  out.theta = state.theta + (scene_.body.theta_m - natural_.body.theta_m);
  out.beta = state.beta;
  return out;
}

TrajectoryPoint MeshMotion::at(double sigma) const {
  const auto [element, t] = mesh_.locate(sigma);
  return row(element, t, sigma);
}

std::vector<TrajectoryPoint> MeshMotion::at_places(
    std::span<const double> places) const {
  std::vector<TrajectoryPoint> rows;
  rows.reserve(1 +
               places.size() * static_cast<std::size_t>(mesh_.num_elements()));
  rows.push_back(row(0, 0.0, 0.0));
  for (int e = 0; e < mesh_.num_elements(); ++e) {
    check_stop(e);
    for (const double t : places) rows.push_back(row(e, t, mesh_.sigma(e, t)));
  }
  return rows;
}

std::vector<TrajectoryPoint> MeshMotion::sample(int per_element) const {
  std::vector<double> places;
  for (int i = 1; i <= per_element; ++i) {
    places.push_back(static_cast<double>(i) / per_element);
  }
  return at_places(places);
}

std::vector<TrajectoryPoint> MeshMotion::fine_sample(int least) const {
  return sample(std::max(2 * mesh_.degree, least / mesh_.num_elements() + 1));
}

// ---- Without limits.

Trajectory::Trajectory(ExtremalCurve curve, const Scene& scene,
                       const Units& units, std::optional<double> transit_time)
    : MeshMotion(curve.scene(), curve.mesh(),
                 gauss_scheme(curve.mesh().degree).nodes.nodes().subspan(1),
                 curve.rolling_time(), scene, units,
                 transit_time.value_or(curve.transit_time() * units.time)),
      curve_(std::move(curve)) {}

double Trajectory::start_angle() const {
  return natural().world.start_speed > 0.0 ? MeshMotion::start_angle()
                                           : brachisto::start_angle(natural());
}

MeshMotion::Place Trajectory::place(int element, double t) const {
  const ExtremalPoint at = curve_.at(element, t);
  return {{at.centre, at.theta, at.beta, at.w,
           slope_rate(natural(), at.state(), at.p, at.beta)},
          at.t,
          at.s};
}

// ---- Under limits.

LimitedMotion::LimitedMotion(LimitedCurve curve, const Scene& scene,
                             const Units& units,
                             std::optional<double> transit_time)
    : MeshMotion(curve.problem().scene(), curve.problem().mesh(),
                 curve.problem().scheme().rule.points, curve.rolling_time(),
                 scene, units,
                 transit_time.value_or(curve.transit_time() * units.time)),
      curve_(std::move(curve)),
      rule_(math::gauss_legendre(curve_.problem().mesh().degree + 1)),
      begins_(1) {
  for (int e = 0; e + 1 < curve_.problem().mesh().num_elements(); ++e) {
    const Passed more = within(e, 1.0);
    begins_.push_back({begins_.back().t + more.t, begins_.back().s + more.s});
  }
}

std::vector<double> LimitedMotion::joints() const {
  std::vector<double> joints;
  const LimitedTime& problem = curve_.problem();
  if (!problem.held()) return joints;
  const auto& in_element = problem.held()->in_element;
  for (std::size_t e = 0; e + 1 < in_element.size(); ++e) {
    if (in_element[e] == in_element[e + 1]) continue;
    joints.push_back(problem.mesh().sigma(static_cast<int>(e), 1.0));
  }
  return joints;
}

// A polynomial takes some points of its mesh for a jump of the control, and
// none of them sees what forces and folds come to at the jump.
PathDiagnostics LimitedMotion::diagnose() const {
  PathDiagnostics out = MeshMotion::diagnose();
  if (curve_.problem().held()) return out;
  const AtJunctions hidden = at_junctions();
  const auto widen = [](double& error, double least, double there) {
    if (least >= 0.0 && !(there > 0.0)) error = std::max(error, least - there);
  };
  widen(out.normal_force_error, out.normal_force_after_rise.value,
        hidden.normal_force);
  widen(out.fold_margin_error, out.min_fold_margin.value, hidden.fold_margin);
  return out;
}

LimitedMotion::AtJunctions LimitedMotion::at_junctions() const {
  const LimitedTime& problem = curve_.problem();
  const std::vector<double>& points = problem.scheme().rule.points;
  const int p = problem.mesh().degree, N = problem.mesh().num_elements();
  AtJunctions out;
  const auto see = [&](int e, const PathInequality& limit, double bound) {
    for (const double t : points) {
      PathState at = place(e, t).state;
      at.beta_rate =
          with_control_at(limit, bound, natural(), curve_.state_at(e, t)).q;
      if (!std::isfinite(at.beta_rate)) continue;
      const Kinematics motion = kinematics(natural(), at);
      out.normal_force = std::min(out.normal_force, motion.R_n);
      out.fold_margin = std::min(out.fold_margin, motion.fold_margin);
    }
  };
  for (std::size_t i = 0; i < problem.limits().size(); ++i) {
    const PathInequality& limit = problem.limits()[i];
    if (!limit.bounds_control()) continue;
    for (int e = 0; e < N; ++e) {
      const int first = std::max(0, e - 1) * p, end = std::min(N, e + 2) * p;
      for (const nlp::Held where : {nlp::Held::AtLower, nlp::Held::AtUpper}) {
        int there = 0;
        for (int c = first; c < end; ++c) {
          if (curve_.held(c, static_cast<int>(i)) == where) ++there;
        }
        if (there > 0 && there < end - first) {
          see(e, limit, bound_of(limit, where));
        }
      }
    }
  }
  return out;
}

LimitedMotion::Passed LimitedMotion::within(int element, double t) const {
  const double hU =
      curve_.problem().mesh().length(element) * curve_.rolling_time();
  Passed sum;
  for (std::size_t i = 0; i < rule_.points.size(); ++i) {
    const auto state = curve_.state_at(element, t * rule_.points[i]);
    const double weight = hU * t * rule_.weights[i];
    sum.t += weight * root_of_inertia(natural(), state.theta, state.beta);
    sum.s += weight * state.w;
  }
  return sum;
}

MeshMotion::Place LimitedMotion::place(int element, double t) const {
  const TurningPoint<double> state = curve_.state_at(element, t);
  const Passed before = begins_[brachisto::at(element)],
               more = within(element, t);
  const double s = before.s + more.s;
  // A body that the problem gives no θ turns all the same.
  const Body& body = natural().body;
  const double theta = body.off_centred() || !body.rolls()
                           ? state.theta
                           : body.theta_m + s / body.radius;
  return {{{state.x, state.z}, theta, state.beta, state.w, state.q},
          before.t + more.t,
          s};
}

namespace {

/// Whether drag, which grows like the speed, has a share in a force that is
/// held from rest on: then the slope changes like the speed, too.
bool drag_bends_at_start(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  if (!(scene.world.air.linear > 0.0)) return false;
  const TurningPoint<double> start = curve.state_at(0, 0.0);
  const auto forms = ForceForms<double>::of(
      scene, pull_on(scene, start.x, start.z, start.theta), start.theta,
      start.beta);
  for (int i = 0; i < problem.layout().num_limits(); ++i) {
    const PathInequality& limit = problem.limits()[at(i)];
    if (limit.bounds_force() && curve.active(0, i) &&
        value_of(limit, forms.by_drag, start) != 0.0) {
      return true;
    }
  }
  return false;
}

}  // namespace

StartLimits LimitedMotion::limits_at_start() const {
  const LimitedTime& problem = curve_.problem();
  const PathState start = place(0, 0.0).state;
  if (!curve_.holds_control(0) || problem.pushed() ||
      drag_bends_at_start(curve_)) {
    return start_limits(natural(), start);
  }
  const TurningPoint<double> first =
      curve_.state_at(0, problem.scheme().rule.points.front());
  return start_limits_of_curvature(natural(), start, first.q / first.w);
}

}  // namespace brachisto
