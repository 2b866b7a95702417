// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/reintegration.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "math/enum_table.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "trajectory/acceleration.hpp"
#include "trajectory/path_by_place.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

/// t, ṡ, s, x, z.
enum : std::size_t { kT, kV, kS, kX, kZ, kSize };
using State = std::array<double, kSize>;
using Integrator = odeint::runge_kutta_fehlberg78<State>;
// Copied before it has computed anything; being static it holds zeros then.
const Integrator kFreshIntegrator;

bool finite(const State& y) {
  return std::all_of(y.begin(), y.end(),
                     [](double value) { return std::isfinite(value); });
}

/// A path under limits as PathByPlace has one without.
class LimitedPath {
 public:
  /// \param curve  must outlive this
  explicit LimitedPath(const LimitedCurve& curve) : curve_(curve) {}

  [[nodiscard]] int num_elements() const {
    return curve_.problem().mesh().num_elements();
  }
  [[nodiscard]] double length() const { return std::max(scene().L, scene().H); }
  [[nodiscard]] double share(int e) const {
    return curve_.problem().mesh().length(e);
  }
  [[nodiscard]] const Scene& scene() const { return curve_.problem().scene(); }
  [[nodiscard]] const Scene& scene_in(int) const { return scene(); }
  /// But for s.
  [[nodiscard]] PathByPlace::Place at(int e, double t) const {
    const TurningPoint<double> path = curve_.state_at(e, t);
    const double hU = share(e) * curve_.rolling_time();
    return {0.0, direction_of(path.beta), hU * path.q, hU * path.w};
  }

 private:
  const LimitedCurve& curve_;
};

/// One motion along a path.
template <class Path>
class Journey {
 public:
  /// \param path  must outlive this
  Journey(Path& path, const State& start) : path_(path), y_(start) {}

  /// In time, for at rest nothing is a function of the place, through a part of
  /// the first element.
  /// \param start  the scene and the slope there, the time that all takes
  MotionEnd leave(const Scene& scene, double beta, double duration);
  /// By the place, from a place of the first element to the end.
  /// \param look  at every step: the element and the place in it
  template <class Look>
  MotionEnd travel(double place, const Look& look) {
    place_ = place;
    for (int e = 0; e < path_.num_elements(); ++e) {
      const MotionEnd end = cross(e, look);
      if (end != MotionEnd::Arrived) return end;
      place_ = 0.0;
    }
    return MotionEnd::Arrived;
  }
  [[nodiscard]] int steps() const { return steps_; }
  /// In the first element.
  [[nodiscard]] double place() const { return place_; }
  /// Where the motion ended.
  [[nodiscard]] const State& state() const { return y_; }

 private:
  static constexpr int kMaxSteps = 1000000;
  static constexpr double kShortest = 1e-15;  // of T or U
  // Rotation in a step [rad]. Fehlberg's estimate does not see what follows
  // from the place alone, for its stages at both ends of a step cancel there;
  // where a body is hardly off-centred that is nearly all of the motion, and
  // steps would run over its waves.
  static constexpr double kMostTurned = 0.8;

  /// From where the body is to the end of element e.
  template <class Look>
  MotionEnd cross(int e, const Look& look);
  /// By the place in element e.
  [[nodiscard]] State rates(int e, const State& y, double place);
  /// Where ṡ² falls to zero, steps shrink towards that place for ever.
  [[nodiscard]] bool about_to_rest(int e) {
    constexpr double kAlmostThere = 1e-9;  // of S
    const State rate = rates(e, y_, place_);
    const double gain = rate[kV] / rate[kT];
    return gain < 0.0 &&
           y_[kV] * y_[kV] / (-2.0 * gain) < kAlmostThere * path_.length();
  }

  Path& path_;
  odeint::controlled_runge_kutta<Integrator> integrator_ =
      odeint::make_controlled(kTolerance, kTolerance, kFreshIntegrator);
  State y_;
  double place_ = 0.0;  ///< in the element where it is
  double step_ = 1e-3;  ///< to try next, as a share of U
  int steps_ = 0;
};

template <class Path>
State Journey<Path>::rates(int e, const State& y, double place) {
  const PathByPlace::Place at = path_.at(e, place);
  const double v = y[kV];
  const double time = at.pace / v;
  const double gain = acceleration(path_.scene_in(e), y[kS], v, {y[kX], y[kZ]},
                                   at.along, v * at.turning / at.pace);
  return {time, gain * time, at.pace, at.pace * at.along.cosine,
          at.pace * at.along.sine};
}

template <class Path>
MotionEnd Journey<Path>::leave(const Scene& scene, double beta,
                               double duration) {
  constexpr double kPart = 0.1;
  constexpr double kFirstStep = 1e-3;
  const bool pushed = scene.world.start_speed > 0.0;
  const auto in_time = [&](const State& y, State& dy, double) {
    const double s = y[kS], v = y[kV];
    Direction along = direction_of(beta);
    // A_s ṡ² tends to 0 at the start although κ_c grows without bound there,
    // for κ_c ~ 1/ṡ.
    double v_kappa = v * rotation_per_length(scene.body);
    if (s > 0.0 || pushed) {
      const PathByPlace::Place at = path_.at(0, path_.in_first(s));
      along = at.along;
      v_kappa = v * at.turning / at.pace;
    }
    dy = {1.0,
          acceleration(path_.scene_in(0), s, v, {y[kX], y[kZ]}, along, v_kappa),
          v, v * along.cosine, v * along.sine};
  };
  double dt = kFirstStep * duration;
  while (y_[kS] < kPart * path_.first_length()) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const State before = y_;
    const double tried = dt;
    double t = y_[kT];
    const bool failed =
        integrator_.try_step(in_time, y_, t, dt) == odeint::fail;
    if (!finite(y_)) return MotionEnd::PathUndefined;
    if (failed && dt < kShortest * duration) return MotionEnd::StepTooSmall;
    if (!failed && y_[kS] > path_.first_length()) {
      // Right over the kink at the element's end: once more, shorter.
      y_ = before;
      dt = 0.25 * tried;
      continue;
    }
    // Where it does not roll forward now it never will.
    if (!failed && !(y_[kV] > 0.0)) return MotionEnd::ComesToRest;
  }
  place_ = path_.in_first(y_[kS]);
  step_ = place_ * path_.share(0);
  return MotionEnd::Arrived;
}

template <class Path>
template <class Look>
MotionEnd Journey<Path>::cross(int e, const Look& look) {
  const double h = path_.share(e);
  const auto by_place = [&](const State& y, State& dy, double place) {
    dy = rates(e, y, place);
  };
  const Body& body = path_.scene_in(e).body;
  const double turn = body.off_centred() ? rotation_per_length(body) : 0.0;
  while (place_ < 1.0) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const double left = 1.0 - place_;
    const double most = kMostTurned / (path_.at(e, place_).pace * turn);
    const bool last = std::min(h * most, step_) >= h * left;
    double step = last ? left : std::min(most, step_ / h);
    const bool failed =
        integrator_.try_step(by_place, y_, place_, step) == odeint::fail;
    if (!finite(y_)) return MotionEnd::PathUndefined;
    if (!(y_[kV] > 0.0)) return MotionEnd::ComesToRest;
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
    if (!failed) look(e, place_);
  }
  return MotionEnd::Arrived;
}

/// v of w there.
double speed_at(const Scene& scene, double w, double theta, double beta) {
  return w / root_of_inertia(scene, theta, beta);
}

/// Beside what the solution says of its end.
template <class Path>
Reintegration compared(const Journey<Path>& journey, MotionEnd end,
                       const Scene& scene, const MovingState& last, double beta,
                       const Costates& p, double T) {
  Reintegration out;
  out.end = end;
  out.steps = journey.steps();
  out.integration_error = kTolerance * out.steps;
  if (!out.arrived()) return out;
  const auto [time, speed, s, x, z] = journey.state();
  const double v = speed_at(scene, last.w, last.theta, beta);
  const Point beyond{x - last.centre.x, z - last.centre.z};
  out.time_error = std::abs(time - T) / T;
  // p = −∂T/∂(x, z): what arriving elsewhere costs or saves.
  out.corrected_time_error =
      std::abs(time + p.p_x * beyond.x + p.p_z * beyond.z - T) / T;
  out.speed_error = std::abs(speed - v) / v;
  out.position_error = std::hypot(beyond.x, beyond.z);
  if (scene.body.off_centred()) {
    out.rotation_error =
        std::abs(scene.body.theta_m + s / scene.body.radius - last.theta);
  }
  return out;
}

}  // namespace

std::string_view describe(MotionEnd end) {
  constexpr auto kSentences = table_by<MotionEnd>(
      "the body reaches the end of the path",
      "the body comes to rest on its way",
      "between the nodes no slope makes 𝓗 minimal, so that there is no path",
      "the path bends too sharply to be integrated along",
      "the motion takes more steps of integration than allowed");
  return kSentences[end];
}

double Reintegration::worst() const {
  const double sum = time_error + speed_error + position_error + rotation_error;
  return arrived() && !std::isnan(sum)
             ? std::max(
                   {time_error, speed_error, position_error, rotation_error})
             : std::numeric_limits<double>::quiet_NaN();
}

Reintegration reintegrate(const ExtremalCurve& curve) {
  const ExtremalPoint first = curve.at(0.0), last = curve.at(1.0);
  const Scene& scene = curve.scene();
  PathByPlace path(curve);
  Journey journey(path, {0.0, scene.world.start_speed, 0.0, first.centre.x,
                         first.centre.z});
  MotionEnd end = journey.leave(scene, first.beta, curve.transit_time());
  if (end == MotionEnd::Arrived) {
    end = journey.travel(journey.place(), [](int, double) {});
  }
  Reintegration out = compared(journey, end, scene, last.state(), last.beta,
                               last.p, curve.transit_time());
  out.share = journey.state()[kS] / curve.arc_length();
  return out;
}

namespace {

/// At the place of the first element of a path under limits: up to there along
/// the same slopes as behind, for so little has been fallen that a place's own
/// error would be a great part of it.
State started(const LimitedCurve& curve, double place) {
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const Body& body = scene.body;
  const TurningPoint<double> rest = curve.state_at(0, 0.0);
  const math::QuadratureRule rule =
      math::gauss_legendre(problem.scheme().degree + 1);
  const double hU = problem.mesh().length(0) * curve.rolling_time();
  double fallen = 0.0, work = 0.0;
  State y{0.0, 0.0, 0.0, rest.x, rest.z};
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const auto at = curve.state_at(0, place * rule.points[i]);
    const double du = hU * place * rule.weights[i];
    y[kT] += du * root_of_inertia(scene, at.theta, at.beta);
    y[kS] += du * at.w;
    y[kX] += du * at.w * std::cos(at.beta);
    fallen += du * at.w * std::sin(at.beta);
    work += du * at.w * speed_gain(scene, at);
  }
  y[kZ] += fallen;
  const TurningPoint<double> here = curve.state_at(0, place);
  const double w =
      problem.pushed() ? here.w
      : scene.world.changes_rates()
          ? std::sqrt(2.0 * work)
          : fall_speed(scene.gravity, energy_height(body, fallen, here.theta));
  y[kV] = speed_at(scene, w, here.theta, here.beta);
  return y;
}

}  // namespace

Reintegration reintegrate(const LimitedCurve& curve) {
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const double begin =
      problem.pushed() ? 0.0 : problem.scheme().rule.points.front();
  LimitedPath path(curve);
  Journey journey(path, started(curve, begin));
  double worst = 0.0, worst_at = 0.0;
  const MotionEnd end = journey.travel(begin, [&](int e, double t) {
    const State& y = journey.state();
    TurningPoint<double> place = curve.state_at(e, t);
    place.w = y[kV] * root_of_inertia(scene, place.theta, place.beta);
    place.x = y[kX];
    place.z = y[kZ];
    const double excess = worst_excess(problem.limits(), scene, place).value;
    if (std::isnan(worst) || excess <= worst) return;
    worst = excess;
    worst_at = problem.mesh().sigma(e, t);
  });
  const LimitedPoint last = curve.at(1.0);
  Reintegration out = compared(journey, end, scene, moving(last.state),
                               last.state.beta, last.p, curve.transit_time());
  out.excess = worst;
  out.excess_at = worst_at;
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
  double within = 1.0;  // a cell, as the curvature is there
  const auto by_place = [&](const OnPath& at, OnPath& rate, double there) {
    const auto [t, s, v] = at;
    const CurvePlace place = motion.curve().at(std::min(there, within));
    const double time = place.speed / v;
    rate = {time, place.speed, acceleration(motion, place, s, v) * time};
  };
  double dq = kFirstStep;
  // Cell by cell: where the curvature has kinks or jumps the steps end, for the
  // error estimate of this method does not see them.
  for (const TrajectoryPoint& cell : cells) {
    within = std::nextafter(cell.sigma, 0.0);
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
