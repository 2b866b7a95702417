// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/motion.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>

#include "brachisto/math/clock.hpp"
#include "math/minima.hpp"
#include "math/roots.hpp"
#include "model/path_inequality.hpp"
#include "trajectory/grip.hpp"
#include "trajectory/self_crossing.hpp"

namespace brachisto {

namespace {

/// What a limit on friction keeps |R_t| − μ R_n to.
double friction_kept(double mu, double wall_ratio) {
  return kForceKept / scale_of_ratio(mu * wall_ratio);
}

/// Friction needed beyond μ R_n. Where a limit holds it at just that it is not:
/// |R_t| − μ R_n ≤ ε is to what limits are kept.
double excess(const Motion& motion, const TrajectoryPoint& at, double mu) {
  const double wall_ratio = motion.scene().body.wall_ratio;
  const double beyond =
      std::abs(at.motion.R_t) - mu * wall_ratio * at.motion.R_n;
  const std::optional<double>& limit = motion.scene().limits.friction;
  return limit ? beyond - friction_kept(*limit, wall_ratio) : beyond;
}

/// The places between rows where the excess changes its sign and back, in their
/// order.
std::vector<TrajectoryPoint> hidden_extremes(
    const Motion& motion, const std::vector<TrajectoryPoint>& rows, double mu) {
  std::vector<TrajectoryPoint> out;
  std::vector<math::Sample> samples(rows.size());
  for (const double sign : {1.0, -1.0}) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      samples[i] = {rows[i].sigma, sign * excess(motion, rows[i], mu)};
    }
    for (const math::Sample& found :
         math::hidden_minima_below(0.0, samples, [&](double sigma) {
           return sign * excess(motion, motion.at(sigma), mu);
         })) {
      out.push_back(motion.at(found.at));
    }
  }
  std::sort(out.begin(), out.end(),
            [](const TrajectoryPoint& a, const TrajectoryPoint& b) {
              return a.sigma < b.sigma;
            });
  return out;
}

/// Time with more than μ R_n between two places next to each other.
double time_above(const Motion& motion, const TrajectoryPoint& from,
                  const TrajectoryPoint& to, double mu) {
  const double ends[] = {excess(motion, from, mu), excess(motion, to, mu)};
  // NaN counts as too much. At the start both forces may vanish: then the first
  // step counts like its end. Where they jump two rows may be of one place.
  const bool before = !(ends[0] <= 0.0);
  const bool after = !(ends[1] <= 0.0);
  if (before == after || ends[0] == 0.0 || ends[1] == 0.0 ||
      !(from.sigma < to.sigma) || std::isnan(ends[0] + ends[1])) {
    return after ? to.t - from.t : 0.0;
  }
  const double change = math::find_root(
      [&](double sigma) { return excess(motion, motion.at(sigma), mu); },
      from.sigma, to.sigma, ends[0], ends[1]);
  const double t = motion.at(change).t;
  return after ? to.t - t : t - from.t;
}

/// With the places between rows where R_t changes its sign: |R_t| has a kink
/// there.
std::vector<TrajectoryPoint> with_changes_of_friction(
    const Motion& motion, const std::vector<TrajectoryPoint>& rows) {
  std::vector<TrajectoryPoint> out;
  for (const TrajectoryPoint& row : rows) {
    if (!out.empty() && out.back().motion.R_t * row.motion.R_t < 0.0 &&
        out.back().sigma < row.sigma) {
      const TrajectoryPoint last = out.back();
      out.push_back(motion.at(math::find_root(
          [&](double sigma) { return motion.at(sigma).motion.R_t; }, last.sigma,
          row.sigma, last.motion.R_t, row.motion.R_t)));
    }
    out.push_back(row);
  }
  return out;
}

/// Share of the transit time on which not |R_t| ≤ μ R_n, of a ball with what
/// its walls press, R_n R/r_e, in place of R_n.
///
/// \param rows  so close that |R_t| − μ R_n has at most one extreme between
///              neighbours, the first one the start, the last one the end;
///              changes of its sign are found as roots
double friction_share(const Motion& motion,
                      const std::vector<TrajectoryPoint>& rows, double mu) {
  const std::vector<TrajectoryPoint> hidden = hidden_extremes(motion, rows, mu);
  auto between = hidden.begin();
  double time = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    check_stop(i);
    const TrajectoryPoint* from = &rows[i - 1];
    for (; between != hidden.end() && between->sigma < rows[i].sigma;
         ++between) {
      time += time_above(motion, *from, *between, mu);
      from = &*between;
    }
    time += time_above(motion, *from, rows[i], mu);
  }
  return time / rows.back().t;
}

}  // namespace

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

using Rows = std::vector<TrajectoryPoint>;
using Figure = std::function<double(const TrajectoryPoint&)>;

double normal_force(const TrajectoryPoint& p) {
  return p.motion.R_n;
}
double less_normal_force(const TrajectoryPoint& p) {
  return -p.motion.R_n;
}
double curvature(const TrajectoryPoint& p) {
  return p.motion.kappa_b;
}
double less_curvature(const TrajectoryPoint& p) {
  return -p.motion.kappa_b;
}
double fold_margin(const TrajectoryPoint& p) {
  return p.motion.fold_margin;
}
/// −ρ with the friction angle ρ = atan2(|R_t|, R_n), R_n standing for what the
/// walls of a ball press.
double less_friction_angle(const TrajectoryPoint& p, double wall_ratio) {
  return -std::atan2(std::abs(p.motion.R_t), wall_ratio * p.motion.R_n);
}
/// The same where a limit |R_t| ≤ μ R_n on friction is kept to ε, as
/// |R_t| ≤ μ R_n + ε = μ (R_n + ε/μ): R_n is known to no more than ε/μ, and
/// the least angle that it may have is asked for. It is at most that of μ, also
/// where both forces vanish but for rounding, where atan2 of them says nothing.
/// Where the limit is not kept nothing is taken off.
Figure less_friction_angle_under(double mu, double wall_ratio) {
  return [=](const TrajectoryPoint& p) {
    const double R_t = std::abs(p.motion.R_t);
    const double there_is =
        mu * wall_ratio * p.motion.R_n + friction_kept(mu, wall_ratio);
    // Written so that a NaN stays.
    return R_t <= there_is ? -std::atan2(mu * R_t, there_is)
                           : less_friction_angle(p, wall_ratio);
  };
}
Figure less_friction_angle_of(const Motion& motion) {
  const std::optional<double> mu = motion.scene().limits.friction;
  const double wall_ratio = motion.scene().body.wall_ratio;
  if (mu) return less_friction_angle_under(*mu, wall_ratio);
  return [=](const TrajectoryPoint& p) {
    return less_friction_angle(p, wall_ratio);
  };
}

/// The samples of a path, narrower next to the start, where forces rise from
/// zero and their sign decides.
Rows sample_path(const Motion& motion) {
  Rows rows = motion.fine_sample(0);
  const double first = rows[1].sigma;
  Rows next_to_start;
  for (const double share : {0.0625, 0.125, 0.25, 0.5, 0.75}) {
    next_to_start.push_back(motion.at(share * first));
  }
  rows.insert(rows.begin() + 1, next_to_start.begin(), next_to_start.end());
  return rows;
}

/// A figure of the path at its samples, the first one replaced by its limit.
std::vector<math::Sample> samples_of(const Rows& rows, double at_start,
                                     const Figure& f) {
  std::vector<math::Sample> samples;
  samples.reserve(rows.size());
  for (const TrajectoryPoint& row : rows)
    samples.push_back({row.sigma, f(row)});
  samples.front().value = at_start;
  return samples;
}

/// The smallest value behind the first sample.
Extreme smallest_behind(const Motion& motion,
                        std::span<const math::Sample> samples,
                        const Figure& f) {
  math::Sample lowest = samples.back();
  for (const math::Sample& sample : samples.subspan(1)) {
    // Written so that a NaN counts as smallest and stays.
    if (!(sample.value >= lowest.value)) lowest = sample;
  }
  const auto figure = [&](double sigma) { return f(motion.at(sigma)); };
  for (const math::Sample& found :
       math::minima_below(lowest.value, samples, figure)) {
    // Next to A forces may be 0/0, and their noise is no minimum.
    if (samples.front().at == 0.0 && found.at < samples[1].at) continue;
    if (found.value < lowest.value) lowest = found;
  }
  return {lowest.value, motion.at(lowest.at).motion.contact.x};
}

/// The infimum for u > 0 of what tends to `at_start`.
Extreme infimum(const Motion& motion, const Rows& rows, double at_start,
                const Figure& f) {
  const Extreme behind =
      smallest_behind(motion, samples_of(rows, at_start, f), f);
  if (!(at_start <= behind.value)) return behind;
  return {at_start, rows.front().motion.contact.x, true};
}

Extreme supremum(const Motion& motion, const Rows& rows, double at_start,
                 const Figure& negative) {
  Extreme extreme = infimum(motion, rows, -at_start, negative);
  extreme.value = -extreme.value;
  return extreme;
}

/// How far the track runs back at most between two places where 1 − r κ_c
/// changes its sign, by ds_b = (1 − r κ_c) ds = ds − r dβ. NaN if that margin
/// is no number somewhere.
double folds_back(const Motion& motion, const Rows& rows, double at_start) {
  const auto margin = [&](double sigma) {
    return fold_margin(motion.at(sigma));
  };
  const double r = motion.scene().body.folding_distance();
  const auto length = [&](double sigma) {
    const TrajectoryPoint at = motion.at(sigma);
    return at.s - r * at.beta;
  };
  std::vector<math::Sample> margins = samples_of(rows, at_start, fold_margin);
  if (!(at_start > 0.0)) {
    // It has no bound there; a fold at A that ends closer to it is none.
    constexpr double kClosest = 1e-4;
    const double next = kClosest * rows[1].sigma;
    margins.front() = {next, margin(next)};
  }
  const std::vector<math::Sample> hidden =
      math::hidden_minima_below(0.0, margins, margin);
  margins.insert(margins.end(), hidden.begin(), hidden.end());
  std::ranges::sort(margins, {}, &math::Sample::at);
  double back = 0.0, from = length(0.0);
  for (std::size_t i = 0; i < margins.size(); ++i) {
    const math::Sample& here = margins[i];
    if (std::isnan(here.value)) return here.value;
    const bool folds = here.value < 0.0;
    const bool last = i + 1 == margins.size();
    if (last && folds) back = std::max(back, from - length(here.at));
    if (last || folds == (margins[i + 1].value < 0.0)) continue;
    const math::Sample& next = margins[i + 1];
    const double there = length(
        math::find_root(margin, here.at, next.at, here.value, next.value));
    if (folds) {
      back = std::max(back, from - there);
    } else {
      from = there;
    }
  }
  return back;
}

/// The smallest value after the stretch from the start on which f only rises.
Extreme after_rise(const Motion& motion, const Rows& rows, double at_start,
                   const Figure& f) {
  const std::vector<math::Sample> samples = samples_of(rows, at_start, f);
  std::size_t top = 0;
  while (top + 2 < samples.size() &&
         samples[top + 1].value > samples[top].value) {
    ++top;
  }
  return smallest_behind(motion, std::span(samples).subspan(top), f);
}

/// ρ at the start, or what it tends to where both forces vanish: at a smooth
/// start R_t = −k a/(A q), so that without inertia only R_t/R_n has a limit.
/// The first rows are places of σ and 2σ.
double friction_angle_at_start(const Motion& motion, const Rows& rows) {
  TrajectoryPoint start = rows.front();
  start.motion.R_n = motion.at_start().normal_force;
  if (start.motion.R_n == 0.0 && motion.scene().body.k == 0.0) {
    const double ratio = motion.scene().body.wall_ratio;
    return less_friction_angle(rows[2], ratio) -
           2.0 * less_friction_angle(rows[1], ratio);
  }
  return -less_friction_angle_of(motion)(start);
}

double friction_angle(const Motion& motion, const Rows& rows, double share) {
  const Figure less = less_friction_angle_of(motion);
  const double t = share * rows.back().t;
  if (!(t > 0.0)) {
    return -infimum(motion, rows, -friction_angle_at_start(motion, rows), less)
                .value;
  }
  const auto next = std::upper_bound(
      rows.begin(), rows.end(), t,
      [](double at, const TrajectoryPoint& row) { return at < row.t; });
  const double sigma = math::find_root(
      [&](double s) { return motion.at(s).t - t; }, (next - 1)->sigma,
      next->sigma, (next - 1)->t - t, next->t - t);
  Rows rest{motion.at(sigma)};
  rest.insert(rest.end(), next, rows.end());
  return -infimum(motion, rest, less(rest.front()), less).value;
}

}  // namespace

double Motion::friction_angle_after(double share) const {
  return friction_angle(*this, sample_path(*this), share);
}

std::vector<double> Motion::least_of(const std::vector<Figure>& figures) const {
  const Rows rows = sample_path(*this);
  std::vector<double> out;
  for (const Figure& figure : figures) {
    const double first = figure(rows.front());
    // What is not defined at rest is there what it tends to.
    const double at_start = std::isfinite(first) ? first : figure(rows[1]);
    out.push_back(infimum(*this, rows, at_start, figure).value);
  }
  return out;
}

PathDiagnostics Motion::diagnose() const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Rows rows = sample_path(*this);
  PathDiagnostics out;
  out.at_start = at_start();
  const double force = out.at_start.normal_force;
  out.min_normal_force = infimum(*this, rows, force, normal_force);
  if (out.at_start.normal_force_rate < 0.0 && out.min_normal_force.at_start) {
    // It falls and has risen again before the first sample.
    const math::Sample dip = math::find_minimum(
        [this](double sigma) { return at(sigma).motion.R_n; }, 0.0,
        rows[1].sigma);
    out.min_normal_force = {dip.value, at(dip.at).motion.contact.x};
  }
  // The slope that a mesh finds at the start is not quite the one that it has
  // to be, and R_n next to it is off by as much as it is there.
  out.normal_force_error = std::abs(rows.front().motion.R_n - force);
  out.max_normal_force = supremum(*this, rows, force, less_normal_force);
  out.normal_force_after_rise = after_rise(*this, rows, force, normal_force);
  out.min_fold_margin =
      infimum(*this, rows, out.at_start.fold_margin, fold_margin);
  if (scene().body.rolls()) {
    out.folds_back = folds_back(*this, rows, out.at_start.fold_margin);
  }
  const double kappa = out.at_start.curvature;
  out.min_curvature = infimum(*this, rows, kappa, curvature);
  out.max_curvature = supremum(*this, rows, kappa, less_curvature);
  out.curvature_after_rise = after_rise(*this, rows, kappa, curvature);
  if (!(out.min_fold_margin.value > 0.0)) {
    out.min_curvature = {-kInfinity, out.min_fold_margin.x};
    out.max_curvature = {kInfinity, out.min_fold_margin.x};
    out.curvature_after_rise = out.min_curvature;
  }
  out.max_abs_slope = std::abs(rows.front().beta);
  std::vector<Point> track;
  track.reserve(rows.size());
  track.push_back(rows.front().motion.contact);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const Kinematics& moving = rows[i].motion;
    out.max_abs_slope = std::max(out.max_abs_slope, std::abs(rows[i].beta));
    track.push_back(moving.contact);
  }
  const Rows of_friction = with_changes_of_friction(*this, rows);
  out.friction_above_0_3 = friction_share(*this, of_friction, 0.3);
  out.friction_above_0_5 = friction_share(*this, of_friction, 0.5);
  out.friction_above_1 = friction_share(*this, of_friction, 1.0);
  for (std::size_t i = 0; i < kGripShares.size(); ++i) {
    const double rho = friction_angle(*this, rows, kGripShares[i]);
    out.least_grip[i] = {kGripShares[i], friction_coefficient(rho)};
  }
  out.self_crossing = self_crossing(track);
  return out;
}

}  // namespace brachisto
