// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/motion.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>

#include "brachisto/trajectory/self_crossing.hpp"
#include "trajectory/friction_share.hpp"

namespace brachisto {

double Motion::tau() const {
  return transit_time() * std::sqrt(2.0 * scene().gravity / scene().H);
}

double Motion::rail_length() const {
  return centre_path_length() +
         scene().body.radius * (start_angle() - end_angle());
}

std::optional<double> Motion::rotation() const {
  if (!scene().body.rolls()) return std::nullopt;
  return centre_path_length() / scene().body.radius;
}

namespace {

/// Smallest value of f(row) along the path.
///
/// Samples bracket the minimum, Brent's method finds it. With `skip_rise` the
/// stretch from the start on which f only rises does not count.
template <class Function>
Extreme smallest(const Motion& motion, const std::vector<TrajectoryPoint>& rows,
                 bool skip_rise, Function&& f) {
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
  constexpr int kHalfTheBits = 26;  // more than a minimum can be located to
  std::uintmax_t evaluations = 40;
  const auto [sigma, value] = boost::math::tools::brent_find_minima(
      [&](double s) { return f(motion.at(s)); }, rows[best - 1].sigma,
      rows[best + 1].sigma, kHalfTheBits, evaluations);
  if (value < extreme.value) {
    extreme = {value, motion.at(sigma).motion.contact.x};
  }
  return extreme;
}

template <class Function>
Extreme largest(const Motion& motion, const std::vector<TrajectoryPoint>& rows,
                Function&& f) {
  Extreme extreme = smallest(motion, rows, false,
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

PathDiagnostics Motion::diagnose() const {
  const std::vector<TrajectoryPoint> rows = fine_sample(0);
  PathDiagnostics out;
  out.min_normal_force = smallest(*this, rows, true, normal_force);
  out.max_normal_force = largest(*this, rows, normal_force);
  out.min_curvature = smallest(*this, rows, true, curvature);
  out.max_curvature = largest(*this, rows, curvature);
  out.min_fold_margin = smallest(*this, rows, false, fold_margin);
  out.max_abs_slope = std::abs(rows.front().beta);
  std::vector<Point> track{rows.front().motion.contact};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Kinematics& moving = rows[i].motion;
    out.max_abs_slope = std::max(out.max_abs_slope, std::abs(rows[i].beta));
    track.push_back(moving.contact);
  }
  out.friction_above_0_3 = friction_share(*this, rows, 0.3);
  out.friction_above_0_5 = friction_share(*this, rows, 0.5);
  out.friction_above_1 = friction_share(*this, rows, 1.0);
  out.self_crossing = self_crossing(track);
  return out;
}

}  // namespace brachisto
