// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/trajectory.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "brachisto/model/start_angle.hpp"
#include "brachisto/trajectory/self_crossing.hpp"

namespace brachisto {

Trajectory::Trajectory(ExtremalCurve curve, const Scene& scene,
                       const Units& units)
    : curve_(std::move(curve)), scene_(scene), units_(units) {}

double Trajectory::transit_time() const {
  return curve_.transit_time() * units_.time;
}

double Trajectory::tau() const {
  return transit_time() * std::sqrt(2.0 * scene_.gravity / scene_.H);
}

double Trajectory::centre_path_length() const {
  return curve_.arc_length() * units_.length;
}

double Trajectory::start_angle() const {
  return brachisto::start_angle(scene_.body);
}

double Trajectory::end_angle() const {
  return curve_.at(1.0).beta;
}

double Trajectory::rail_length() const {
  return centre_path_length() +
         scene_.body.radius * (start_angle() - end_angle());
}

std::optional<double> Trajectory::rotation() const {
  if (!scene_.body.rolls()) return std::nullopt;
  return centre_path_length() / scene_.body.radius;
}

TrajectoryPoint Trajectory::convert(const ExtremalPoint& point,
                                    double sigma) const {
  const Scene& natural = curve_.scene();
  PathState state{point.centre, point.theta, point.beta, point.w, 0.0};
  state.beta_rate = slope_rate(natural.body, natural.gravity,
                               {point.theta, point.w}, point.p, point.beta);
  TrajectoryPoint out;
  out.motion = kinematics(natural.body, natural.gravity, state);
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
  out.theta = point.theta;
  out.beta = point.beta;
  return out;
}

TrajectoryPoint Trajectory::at(double sigma) const {
  return convert(curve_.at(sigma), sigma);
}

std::vector<TrajectoryPoint> Trajectory::at_nodes() const {
  std::vector<TrajectoryPoint> rows;
  const Mesh& mesh = curve_.mesh();
  const auto& nodes = collocation_scheme(mesh.degree).nodes;
  rows.reserve(static_cast<std::size_t>(mesh.num_nodes()));
  for (int node = 0; node < mesh.num_nodes(); ++node) {
    const int e = std::min(node / mesh.degree, mesh.num_elements() - 1);
    const double t =
        nodes.nodes()[static_cast<std::size_t>(node - e * mesh.degree)];
    const double sigma =
        mesh.boundaries[static_cast<std::size_t>(e)] + t * mesh.length(e);
    rows.push_back(convert(curve_.at(e, t), sigma));
  }
  return rows;
}

std::vector<TrajectoryPoint> Trajectory::sample(int per_element) const {
  std::vector<TrajectoryPoint> rows{convert(curve_.at(0, 0.0), 0.0)};
  const Mesh& mesh = curve_.mesh();
  for (int e = 0; e < mesh.num_elements(); ++e) {
    for (int i = 1; i <= per_element; ++i) {
      const double t = static_cast<double>(i) / per_element;
      const double sigma =
          mesh.boundaries[static_cast<std::size_t>(e)] + t * mesh.length(e);
      rows.push_back(convert(curve_.at(e, t), sigma));
    }
  }
  return rows;
}

namespace {

/// Smallest value of f(row) along the path.
///
/// Samples bracket the minimum, Brent's method finds it. With `skip_rise` the
/// stretch from the start on which f only rises does not count.
template <class Function>
Extreme smallest(const Trajectory& trajectory,
                 const std::vector<TrajectoryPoint>& rows, bool skip_rise,
                 Function&& f) {
  std::size_t first = 1;
  if (skip_rise) {
    while (first + 1 < rows.size() && f(rows[first + 1]) > f(rows[first])) {
      ++first;
    }
  }
  std::size_t best = first;
  for (std::size_t i = first; i < rows.size(); ++i) {
    // Written so that a NaN counts as smallest and stays.
    if (!(f(rows[i]) >= f(rows[best]))) best = i;
  }
  Extreme extreme{f(rows[best]), rows[best].motion.contact.x};
  if (best == first || best + 1 == rows.size()) return extreme;
  const double u_end = rows.back().u;
  constexpr int kHalfTheBits = 26;  // more than a minimum can be located to
  std::uintmax_t evaluations = 40;
  const auto [sigma, value] = boost::math::tools::brent_find_minima(
      [&](double s) { return f(trajectory.at(s)); }, rows[best - 1].u / u_end,
      rows[best + 1].u / u_end, kHalfTheBits, evaluations);
  if (value < extreme.value) {
    extreme = {value, trajectory.at(sigma).motion.contact.x};
  }
  return extreme;
}

template <class Function>
Extreme largest(const Trajectory& trajectory,
                const std::vector<TrajectoryPoint>& rows, Function&& f) {
  Extreme extreme = smallest(trajectory, rows, false,
                             [&](const TrajectoryPoint& p) { return -f(p); });
  extreme.value = -extreme.value;
  return extreme;
}

double normal_force(const TrajectoryPoint& p) {
  return p.motion.R_n;
}
double curvature(const TrajectoryPoint& p) {
  return p.motion.kappa_b;
}
double fold_margin(const TrajectoryPoint& p) {
  return p.motion.fold_margin;
}

}  // namespace

PathDiagnostics Trajectory::diagnose() const {
  const std::vector<TrajectoryPoint> rows = sample(2 * curve_.mesh().degree);
  PathDiagnostics out;
  out.min_normal_force = smallest(*this, rows, true, normal_force);
  out.max_normal_force = largest(*this, rows, normal_force);
  out.min_curvature = smallest(*this, rows, true, curvature);
  out.max_curvature = largest(*this, rows, curvature);
  out.min_fold_margin = smallest(*this, rows, false, fold_margin);
  out.max_abs_slope = std::abs(rows.front().beta);
  std::vector<Point> track{rows.front().motion.contact};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Kinematics& motion = rows[i].motion;
    out.max_abs_slope = std::max(out.max_abs_slope, std::abs(rows[i].beta));
    track.push_back(motion.contact);
    // Shares count the step that ends here.
    const double share = (rows[i].t - rows[i - 1].t) / rows.back().t;
    const double friction = std::abs(motion.R_t);
    if (!(friction <= 0.3 * motion.R_n)) out.friction_above_0_3 += share;
    if (!(friction <= 0.5 * motion.R_n)) out.friction_above_0_5 += share;
    if (!(friction <= motion.R_n)) out.friction_above_1 += share;
  }
  out.self_crossing = self_crossing(track);
  return out;
}

}  // namespace brachisto
