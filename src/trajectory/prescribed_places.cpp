// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A motion on a given path, place by place.

#include <algorithm>
#include <cmath>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "trajectory/prescribed_motion.hpp"

namespace brachisto {

namespace {

constexpr int kFineSamplesPerCell = 8;

}  // namespace

int PrescribedMotion::cell_of(double q) const {
  const auto after = std::upper_bound(
      cells_.begin() + 1, cells_.end() - 1, q,
      [](double value, const Sums& cell) { return value < cell.q; });
  return static_cast<int>(after - cells_.begin()) - 1;
}

PrescribedMotion::Sums PrescribedMotion::sums_at(double q) const {
  const Sums& from = cells_[brachisto::at(cell_of(q))];
  // Where the cells were passed no place between their nodes can stop the body
  // but for rounding.
  const std::variant<Sums, Stall> at = advance(from, q);
  return std::holds_alternative<Sums>(at) ? std::get<Sums>(at) : from;
}

PrescribedMotion::Step PrescribedMotion::step_to(int cell, double q) const {
  const Sums& from = cells_[brachisto::at(cell)];
  Points points;
  const std::variant<Sums, Stall> end = advance(from, q, points);
  Step step;
  step.width = q - from.q;
  // As in sums_at().
  step.t = std::holds_alternative<Sums>(end) ? std::get<Sums>(end).t : from.t;
  step.places = points.places;
  step.s = points.s;
  for (std::size_t i = 0; i < step.v.size(); ++i) {
    step.v[i] = std::sqrt(2.0 * points.energy[i]) /
                root_of_inertia(scene_, theta_after(points.s[i]),
                                points.places[i].beta);
  }
  return step;
}

double PrescribedMotion::place_at_length(double s) const {
  const auto after = std::upper_bound(
      cells_.begin() + 1, cells_.end() - 1, s,
      [](double value, const Sums& cell) { return value < cell.s; });
  const Sums& from = *(after - 1);
  const Sums& to = *after;
  // s grows like q², and q by Newton's method from there.
  const double share = std::clamp((s - from.s) / (to.s - from.s), 0.0, 1.0);
  double q = std::sqrt(std::lerp(from.q * from.q, to.q * to.q, share));
  constexpr int kMostSteps = 20;
  for (int i = 0; i < kMostSteps; ++i) {
    const double speed = curve_->pace(q).speed;
    if (!(speed > 0.0)) break;
    const double length = from.s + length_between(from.q, q);
    const double step = (s - length) / speed;
    q = std::clamp(q + step, from.q, to.q);
    // The next step would be the square of this one, over the length on which
    // the speed changes: q next to the start, a cell elsewhere.
    if (std::abs(step) <= 1e-8 * std::min(q, to.q - from.q)) break;
  }
  return q;
}

TrajectoryPoint PrescribedMotion::point_at(const Sums& sums) const {
  const CurvePlace place = curve_->at(sums.q);
  TrajectoryPoint out;
  out.sigma = sums.q;
  out.u = sums.u;
  out.t = sums.t;
  out.s = sums.s;
  out.centre = point_of(*curve_, place);
  out.theta = theta_after(sums.s);
  out.beta = place.beta;
  PathState state{out.centre, out.theta, place.beta, 0.0, 0.0};
  const double E = scene_.world.brakes() ? sums.energy : energy(place, sums.s);
  if (sums.q > 0.0 && E > 0.0) {
    state.w = std::sqrt(2.0 * E);
    // dβ/du; at the start the limit of dq/du.
    state.beta_rate = place.turning * state.w / place.speed;
  } else {
    state.w = start_w();
    state.beta_rate = start_slope_rate();
  }
  out.motion = kinematics(scene_, state);
  if (state.w == 0.0) {
    // There κ_c = β_u/w is a limit.
    const StartLimits start = at_start();
    out.motion.kappa_b = start.curvature;
    out.motion.fold_margin = start.fold_margin;
  }
  return out;
}

StartLimits PrescribedMotion::at_start() const {
  const PathState start{curve_->start(), scene_.body.theta_m, start_.beta,
                        start_w(), start_slope_rate()};
  if (start_energy_ > 0.0 || start_.turning != 0.0) {
    return start_limits(scene_, start);
  }
  return start_limits_of_curvature(scene_, start, start_curvature());
}

std::vector<TrajectoryPoint> PrescribedMotion::at_nodes() const {
  std::vector<TrajectoryPoint> rows;
  rows.reserve(cells_.size());
  for (const Sums& cell : cells_) rows.push_back(point_at(cell));
  return rows;
}

std::vector<TrajectoryPoint> PrescribedMotion::fine_sample(int least) const {
  const int per_cell = std::max(kFineSamplesPerCell, least / num_cells() + 1);
  std::vector<TrajectoryPoint> rows{point_at(cells_.front())};
  for (std::size_t c = 1; c < cells_.size(); ++c) {
    check_stop();
    const double from = cells_[c - 1].q;
    for (int i = 1; i <= per_cell; ++i) {
      rows.push_back(at(from + (cells_[c].q - from) * i / per_cell));
    }
  }
  return rows;
}

}  // namespace brachisto
