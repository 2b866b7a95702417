// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/reintegration.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"
#include "trajectory/path_by_length.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

// s, ṡ, x, z
using State = std::array<double, 4>;

/// The equation of motion, in time.
class Motion {
 public:
  Motion(const Scene& scene, const PathByLength& path, double start_angle)
      : scene_(scene), path_(path), start_angle_(start_angle) {}

  /// Rates while the body is in element e.
  void rates(int e, const State& y, State& dy) const {
    const Body& body = scene_.body;
    const double s = y[0];
    const double v = y[1];
    double theta = body.theta_m;
    double turning = 0.0;  // 1/r
    if (body.rolls()) {
      turning = 1.0 / body.radius;
      theta += s * turning;
    }
    double beta = start_angle_;
    double A_slope_v2 = 0.0;  // A_s ṡ²; tends to 0 at the start although κ_c
                              // grows without bound, for κ_c ~ 1/ṡ
    if (s > 0.0) {
      const PathByLength::Place place = path_.at(e, s);
      beta = place.beta;
      A_slope_v2 = -2.0 * body.eta_m * std::cos(theta - beta) * v *
                   (v * turning - v * place.kappa);
    }
    const double A = inertia_factor(body, theta, beta);
    dy[0] = v;
    dy[1] =
        (scene_.gravity * energy_slope(body, theta, beta) - 0.5 * A_slope_v2) /
        A;
    dy[2] = v * std::cos(beta);
    dy[3] = v * std::sin(beta);
  }

 private:
  const Scene& scene_;
  const PathByLength& path_;
  double start_angle_;
};

}  // namespace

namespace {

using Stepper = odeint::runge_kutta_fehlberg78<State>;

// Copied before it has computed anything; being static it holds zeros then.
const Stepper kFreshStepper;

bool finite(const State& y) {
  return std::all_of(y.begin(), y.end(),
                     [](double value) { return std::isfinite(value); });
}

/// One motion from rest.
class Release {
 public:
  Release(const Motion& motion, const PathByLength& path, Point start,
          double duration)
      : motion_(motion),
        path_(path),
        duration_(duration),
        q_{0.0, 0.0, start.x, start.z} {}

  MotionEnd run() {
    MotionEnd end = leave();
    for (int e = 0; e < path_.num_elements() && end == MotionEnd::Arrived;
         ++e) {
      end = cross(e);
    }
    return end;
  }
  [[nodiscard]] double length() const { return s_; }
  [[nodiscard]] int steps() const { return steps_; }
  /// t, ṡ, x, z where the motion ended.
  [[nodiscard]] const State& state() const { return q_; }

 private:
  static constexpr int kMaxSteps = 1000000;
  static constexpr double kShortest = 1e-15;  // of T or S

  /// In time, for at rest nothing is a function of s, through a part of the
  /// first element.
  MotionEnd leave();
  /// In s, from where the body is to the end of element e.
  MotionEnd cross(int e);
  /// Where ṡ² falls to zero, steps in s shrink towards that place for ever.
  [[nodiscard]] bool about_to_rest(int e) const {
    constexpr double kAlmostThere = 1e-9;  // of S
    State rate{};
    motion_.rates(e, {s_, q_[1], q_[2], q_[3]}, rate);
    return rate[1] < 0.0 && q_[1] * q_[1] / (-2.0 * rate[1]) <
                                kAlmostThere * path_.end(path_.num_elements());
  }

  const Motion& motion_;
  const PathByLength& path_;
  double duration_;
  State q_;
  double s_ = 0.0;
  double ds_ = 0.0;
  int steps_ = 0;
};

MotionEnd Release::leave() {
  constexpr double kPart = 0.1;
  constexpr double kFirstStep = 1e-3;
  const double goal = kPart * path_.end(1);
  auto stepper = odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
  const auto in_time = [&](const State& y, State& dy, double) {
    motion_.rates(0, y, dy);
  };
  double t = 0.0;
  double dt = kFirstStep * duration_;
  State y{0.0, 0.0, q_[2], q_[3]};
  while (y[0] < goal) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const State before = y;
    const double t_before = t;
    const double tried = dt;
    const bool failed = stepper.try_step(in_time, y, t, dt) == odeint::fail;
    if (!finite(y)) return MotionEnd::PathUndefined;
    if (failed && dt < kShortest * duration_) return MotionEnd::StepTooSmall;
    if (!failed && y[0] > path_.end(1)) {
      // Right over the kink at the element's end: once more, shorter.
      y = before;
      t = t_before;
      dt = 0.25 * tried;
      continue;
    }
    // Where it does not roll forward now it never will.
    if (!failed && !(y[1] > 0.0)) return MotionEnd::ComesToRest;
  }
  q_ = {t, y[1], y[2], y[3]};
  s_ = y[0];
  ds_ = s_;
  return MotionEnd::Arrived;
}

MotionEnd Release::cross(int e) {
  const double end = path_.end(e + 1);
  auto stepper = odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
  const auto by_length = [&](const State& q, State& dq, double s) {
    State rate{};
    motion_.rates(e, {s, q[1], q[2], q[3]}, rate);
    dq = {1.0 / q[1], rate[1] / q[1], rate[2] / q[1], rate[3] / q[1]};
  };
  while (s_ < end) {
    check_stop();
    if (++steps_ > kMaxSteps) return MotionEnd::TooManySteps;
    const bool last = ds_ >= end - s_;
    double ds = last ? end - s_ : ds_;
    const bool failed = stepper.try_step(by_length, q_, s_, ds) == odeint::fail;
    if (!finite(q_)) return MotionEnd::PathUndefined;
    if (!(q_[1] > 0.0)) return MotionEnd::ComesToRest;
    if (failed && ds < kShortest * path_.end(path_.num_elements())) {
      return about_to_rest(e) ? MotionEnd::ComesToRest
                              : MotionEnd::StepTooSmall;
    }
    if (failed || !last) {
      ds_ = ds;
    } else {
      s_ = end;  // but for rounding it is
      ds_ = std::max(ds_, ds);
    }
  }
  return MotionEnd::Arrived;
}

}  // namespace

std::string_view describe(MotionEnd end) {
  switch (end) {
    case MotionEnd::Arrived:
      return "the body reaches the end of the path";
    case MotionEnd::ComesToRest:
      return "the body comes to rest on its way";
    case MotionEnd::PathUndefined:
      return "between the nodes no slope makes 𝓗 minimal, so that there is no "
             "path";
    case MotionEnd::StepTooSmall:
      return "the path bends too sharply to be integrated along";
    case MotionEnd::TooManySteps:
      return "the motion takes more steps of integration than allowed";
  }
  return "unknown end of the motion";
}

Reintegration reintegrate(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const PathByLength path(curve);
  const Motion motion(scene, path, curve.at(0.0).beta);
  const ExtremalPoint end = curve.at(1.0);
  const double T = curve.transit_time();
  const double S = curve.arc_length();

  Release release(motion, path, curve.at(0.0).centre, T);
  Reintegration out;
  out.end = release.run();
  out.steps = release.steps();
  out.integration_error = kTolerance * out.steps;
  out.share = release.length() / S;
  if (!out.arrived()) return out;
  const auto [time, speed, x, z] = release.state();
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

}  // namespace brachisto
