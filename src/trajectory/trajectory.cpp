// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/trajectory.hpp"

#include <algorithm>
#include <utility>

#include "brachisto/math/stop_condition.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

Trajectory::Trajectory(ExtremalCurve curve, const Scene& scene,
                       const Units& units, std::optional<double> transit_time)
    : curve_(std::move(curve)),
      scene_(scene),
      units_(units),
      transit_time_(
          transit_time.value_or(curve_.transit_time() * units_.time)) {}

double Trajectory::start_angle() const {
  const World& world = scene_.world;
  if (world.ordinary()) return brachisto::start_angle(scene_.body);
  return world.start_speed > 0.0 ? curve_.at(0.0).beta
                                 : brachisto::start_angle(curve_.scene());
}

StartLimits Trajectory::at_start() const {
  const Scene& natural = curve_.scene();
  const ExtremalPoint start = curve_.at(0.0);
  const double beta_rate =
      slope_rate(natural, start.state(), start.p, start.beta);
  if (scene_.world.ordinary()) {
    return start_limits(scene_.body, start_angle(), beta_rate / units_.time);
  }
  StartLimits limits = start_limits(
      natural, {start.centre, start.theta, start_angle(), start.w, beta_rate});
  limits.normal_force_rate /= units_.time;
  limits.curvature /= units_.length;
  return limits;
}

TrajectoryPoint Trajectory::convert(const ExtremalPoint& point,
                                    double sigma) const {
  const Scene& natural = curve_.scene();
  PathState state{point.centre, point.theta, point.beta, point.w, 0.0};
  state.beta_rate = slope_rate(natural, point.state(), point.p, point.beta);
  TrajectoryPoint out;
  out.sigma = sigma;
  out.motion = kinematics(natural, state);
  const auto scale = [&](Point& p) {
    p.x *= units_.length;
    p.z *= units_.length;
  };
  scale(out.motion.mass_centre);
  scale(out.motion.contact);
  out.motion.v_c *= units_.speed();
  out.motion.omega /= units_.time;
  out.motion.kappa_b /= units_.length;
  out.centre = point.centre;
  scale(out.centre);
  out.u = sigma * curve_.rolling_time() * units_.time;
  out.t = point.t * units_.time;
  out.s = point.s * units_.length;
  out.theta = point.theta + (scene_.body.theta_m - natural.body.theta_m);
  out.beta = point.beta;
  return out;
}

std::vector<TrajectoryPoint> Trajectory::at_places(
    std::span<const double> places) const {
  const Mesh& mesh = curve_.mesh();
  const CollocationScheme& scheme = gauss_scheme(mesh.degree);
  std::vector<ElementPlace> in_element;
  for (const double t : places) in_element.emplace_back(scheme, t);
  std::vector<TrajectoryPoint> rows;
  rows.reserve(1 + in_element.size() *
                       static_cast<std::size_t>(mesh.num_elements()));
  rows.push_back(convert(curve_.at(0, 0.0), 0.0));
  for (int e = 0; e < mesh.num_elements(); ++e) {
    check_stop(e);
    for (const ElementPlace& place : in_element) {
      rows.push_back(convert(curve_.at(e, place), mesh.sigma(e, place.t)));
    }
  }
  return rows;
}

std::vector<TrajectoryPoint> Trajectory::at_nodes() const {
  return at_places(
      gauss_scheme(curve_.mesh().degree).nodes.nodes().subspan(1));
}

std::vector<TrajectoryPoint> Trajectory::sample(int per_element) const {
  std::vector<double> places;
  for (int i = 1; i <= per_element; ++i) {
    places.push_back(static_cast<double>(i) / per_element);
  }
  return at_places(places);
}

std::vector<TrajectoryPoint> Trajectory::fine_sample(int least) const {
  const Mesh& mesh = curve_.mesh();
  return sample(std::max(2 * mesh.degree, least / mesh.num_elements() + 1));
}

}  // namespace brachisto
