// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/reintegration.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"
#include "model/inertia.hpp"
#include "trajectory/acceleration.hpp"
#include "trajectory/path_by_place.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

using State = std::array<double, 4>;
using Integrator = odeint::runge_kutta_fehlberg78<State>;
// Copied before it has computed anything; being static it holds zeros then.
const Integrator kFreshIntegrator;

bool finite(const State& y) {
  return std::all_of(y.begin(), y.end(),
                     [](double value) { return std::isfinite(value); });
}

/// One motion from the start, at rest or with its speed.
class Journey {
 public:
  explicit Journey(const ExtremalCurve& curve)
      : scene_(curve.scene()),
        start_(curve.at(0.0)),
        duration_(curve.transit_time()),
        path_(curve),
        y_{0.0, scene_.world.start_speed, start_.centre.x, start_.centre.z} {}

  MotionEnd run() {
    MotionEnd end = leave();
    for (int e = 0; e < path_.num_elements() && end == MotionEnd::Arrived;
         ++e) {
      element_ = e;
      end = cross(e);
    }
    return end;
  }
  [[nodiscard]] int steps() const { return steps_; }
  /// s there.
  [[nodiscard]] double length() {
    return element_ < 0 ? 0.0 : path_.at(element_, place_).s;
  }
  /// t, ṡ, x, z where the motion ended.
  [[nodiscard]] const State& state() const { return y_; }

 private:
  static constexpr int kMaxSteps = 1000000;
  static constexpr double kShortest = 1e-15;  // of T or U

  /// In time, for at rest nothing is a function of the place, through a part of
  /// the first element.
  MotionEnd leave();
  /// By the place, from where the body is to the end of element e.
  MotionEnd cross(int e);
  /// By the place in element e.
  [[nodiscard]] State rates(int e, const State& y, double place);
  /// Where ṡ² falls to zero, steps shrink towards that place for ever.
  [[nodiscard]] bool about_to_rest(int e) {
    constexpr double kAlmostThere = 1e-9;  // of S
    const State rate = rates(e, y_, place_);
    const double gain = rate[1] / rate[0];
    return gain < 0.0 &&
           y_[1] * y_[1] / (-2.0 * gain) < kAlmostThere * path_.length();
  }

  const Scene& scene_;
  const ExtremalPoint start_;
  const double duration_;
  PathByPlace path_;
  odeint::controlled_runge_kutta<Integrator> integrator_ =
      odeint::make_controlled(kTolerance, kTolerance, kFreshIntegrator);
  State y_;
  int element_ = -1;    ///< where it is; none while it leaves
  double place_ = 0.0;  ///< in it
  double step_ = 0.0;   ///< to try next, as a share of U
  int steps_ = 0;
};

State Journey::rates(int e, const State& y, double place) {
  const PathByPlace::Place at = path_.at(e, place);
  const double v = y[1];
  const double time = at.pace / v;
  const double gain = acceleration(path_.scene_in(e), at.s, v, {y[2], y[3]},
                                   at.along, v * at.turning / at.pace);
  return {time, gain * time, at.pace * at.along.cosine,
          at.pace * at.along.sine};
}

MotionEnd Journey::leave() {
  constexpr double kPart = 0.1;
  constexpr double kFirstStep = 1e-3;
  const bool pushed = scene_.world.start_speed > 0.0;
  // Of s, ṡ, x, z.
  const auto in_time = [&](const State& y, State& dy, double) {
    const auto [s, v, x, z] = y;
    Direction along = direction_of(start_.beta);
    // A_s ṡ² tends to 0 at the start although κ_c grows without bound there,
    // for κ_c ~ 1/ṡ.
    double v_kappa = v * rotation_per_length(scene_.body);
    if (s > 0.0 || pushed) {
      const PathByPlace::Place at = path_.at(0, path_.in_first(s));
      along = at.along;
      v_kappa = v * at.turning / at.pace;
    }
    dy = {v, acceleration(path_.scene_in(0), s, v, {x, z}, along, v_kappa),
          v * along.cosine, v * along.sine};
  };
  double t = 0.0;
  double dt = kFirstStep * duration_;
  State y{0.0, y_[1], y_[2], y_[3]};
  while (y[0] < kPart * path_.first_length()) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const State before = y;
    const double t_before = t;
    const double tried = dt;
    const bool failed = integrator_.try_step(in_time, y, t, dt) == odeint::fail;
    if (!finite(y)) return MotionEnd::PathUndefined;
    if (failed && dt < kShortest * duration_) return MotionEnd::StepTooSmall;
    if (!failed && y[0] > path_.first_length()) {
      // Right over the kink at the element's end: once more, shorter.
      y = before;
      t = t_before;
      dt = 0.25 * tried;
      continue;
    }
    // Where it does not roll forward now it never will.
    if (!failed && !(y[1] > 0.0)) return MotionEnd::ComesToRest;
  }
  y_ = {t, y[1], y[2], y[3]};
  place_ = path_.in_first(y[0]);
  step_ = place_ * path_.share(0);
  return MotionEnd::Arrived;
}

MotionEnd Journey::cross(int e) {
  const double h = path_.share(e);
  if (e > 0) place_ = 0.0;
  const auto by_place = [&](const State& y, State& dy, double place) {
    dy = rates(e, y, place);
  };
  while (place_ < 1.0) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const double left = 1.0 - place_;
    const bool last = step_ >= h * left;
    double step = last ? left : step_ / h;
    const bool failed =
        integrator_.try_step(by_place, y_, place_, step) == odeint::fail;
    if (!finite(y_)) return MotionEnd::PathUndefined;
    if (!(y_[1] > 0.0)) return MotionEnd::ComesToRest;
    if (failed && h * step < kShortest) {
      return about_to_rest(e) ? MotionEnd::ComesToRest
                              : MotionEnd::StepTooSmall;
    }
    if (failed || !last) {
      step_ = h * step;
    } else {
      place_ = 1.0;  // but for rounding it is
      step_ = std::max(step_, h * step);
    }
  }
  return MotionEnd::Arrived;
}

}  // namespace

std::string_view describe(MotionEnd end) {
  constexpr std::array<std::string_view, 5> kSentences{
      "the body reaches the end of the path",
      "the body comes to rest on its way",
      "between the nodes no slope makes 𝓗 minimal, so that there is no path",
      "the path bends too sharply to be integrated along",
      "the motion takes more steps of integration than allowed"};
  static_assert(kSentences.size() ==
                static_cast<std::size_t>(MotionEnd::TooManySteps) + 1);
  return kSentences.at(static_cast<std::size_t>(end));
}

Reintegration reintegrate(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const ExtremalPoint end = curve.at(1.0);
  const double T = curve.transit_time();
  const double S = curve.arc_length();

  Journey journey(curve);
  Reintegration out;
  out.end = journey.run();
  out.steps = journey.steps();
  out.integration_error = kTolerance * out.steps;
  const auto [time, speed, x, z] = journey.state();
  out.share = journey.length() / S;
  if (!out.arrived()) return out;
  const double v =
      end.w / std::sqrt(inertia_factor(scene.body, end.theta, end.beta));
  const Point beyond{x - end.centre.x, z - end.centre.z};
  out.time_error = std::abs(time - T) / T;
  // p = −∂T/∂(x, z): what arriving elsewhere costs or saves.
  out.corrected_time_error =
      std::abs(time + curve.p_x() * beyond.x + curve.p_z() * beyond.z - T) / T;
  out.speed_error = std::abs(speed - v) / v;
  out.position_error = std::hypot(beyond.x, beyond.z);
  if (scene.body.rolls()) {
    out.rotation_error =
        std::abs(scene.body.theta_m + S / scene.body.radius - end.theta);
  }
  return out;
}

namespace {

/// t, s, ṡ on a given path.
using OnPath = std::array<double, 3>;
using PathStepper =
    odeint::controlled_runge_kutta<odeint::runge_kutta_fehlberg78<OnPath>>;

/// s̈ at a place of the path.
double acceleration(const PrescribedMotion& motion, const CurvePlace& place,
                    double s, double v) {
  // At the start from rest v κ_c stays bounded, and A_s v² vanishes with v.
  const Scene& scene = motion.scene();
  const double v_kappa =
      place.speed > 0.0 ? v * place.turning / place.speed
                        : scene.world.start_speed * motion.start_curvature();
  return acceleration(scene, s, v, point_of(motion.curve(), place),
                      direction_of(place.beta), v_kappa);
}

/// From `from` to `to`, in steps the next of which is `step`. False if steps
/// become too short, as where air brakes within no time, or too many.
template <class Rates>
bool integrate(PathStepper& stepper, const Rates& rates, OnPath& y, double from,
               double to, double& step) {
  constexpr double kShortest = 1e-15;
  constexpr int kMostSteps = 100000;
  const double shortest = kShortest * std::abs(to);
  for (int steps = 0; from < to; ++steps) {
    check_stop();
    if (steps == kMostSteps) return false;
    const bool last = step >= to - from;
    double tried = last ? to - from : step;
    const bool failed = stepper.try_step(rates, y, from, tried) == odeint::fail;
    if (failed && tried < shortest) return false;
    if (failed || !last) {
      step = tried;
    } else {
      from = to;  // but for rounding it is
      step = std::max(step, tried);
    }
  }
  return true;
}

}  // namespace

double reintegration_error(const PrescribedMotion& motion, double from) {
  // As kFreshIntegrator.
  static const odeint::runge_kutta_fehlberg78<OnPath> kFreshStepper;
  constexpr double kLoose = 1e-13;
  constexpr double kFirstStep = 1e-3;
  constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();
  const double T = motion.transit_time();
  const std::vector<TrajectoryPoint> cells = motion.at_nodes();
  PathStepper stepper = odeint::make_controlled(kLoose, kLoose, kFreshStepper);
  OnPath y{0.0, 0.0, motion.scene().world.start_speed};
  double q = from;
  if (from > 0.0) {
    const TrajectoryPoint start = motion.at(from);
    y = {start.t, start.s, start.motion.v_c};
  } else {
    // At rest nothing is a function of the place: the first cell in time.
    const auto in_time = [&](const OnPath& at, OnPath& rate, double) {
      const auto [t, s, v] = at;
      const double along = std::clamp(s, 0.0, motion.centre_path_length());
      const CurvePlace place = motion.curve().at(motion.place_at_length(along));
      rate = {1.0, v, acceleration(motion, place, along, v)};
    };
    double dt = kFirstStep * T;
    if (!integrate(stepper, in_time, y, 0.0, cells[1].t, dt)) return kFailed;
    q = motion.place_at_length(y[1]);
  }
  const auto by_place = [&](const OnPath& at, OnPath& rate, double there) {
    const auto [t, s, v] = at;
    const CurvePlace place = motion.curve().at(there);
    const double time = place.speed / v;
    rate = {time, place.speed, acceleration(motion, place, s, v) * time};
  };
  double dq = kFirstStep;
  // Cell by cell: where the curvature has kinks the steps end, for the error
  // estimate of this method does not see them.
  for (const TrajectoryPoint& cell : cells) {
    if (!integrate(stepper, by_place, y, q, cell.sigma, dq)) return kFailed;
    q = std::max(q, cell.sigma);
  }
  const double v = motion.at(1.0).motion.v_c;
  const double late = std::abs(y[0] - T) / T;
  const double faster = std::abs(y[2] - v) / v;
  // The larger of two may not be the one that is no number.
  return std::isnan(late + faster) ? kFailed : std::max(late, faster);
}

}  // namespace brachisto
