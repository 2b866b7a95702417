// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/reintegration.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>

#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

/// The path as a function of its arc length.
class PathByLength {
 public:
  explicit PathByLength(const ExtremalCurve& curve) : curve_(curve) {
    const Mesh& mesh = curve.mesh();
    for (int e = 0; e < mesh.num_elements(); ++e) {
      starts_.push_back(curve.at(e, 0.0).s);
    }
  }

  struct Place {
    double beta, kappa;  // slope angle and curvature of the centre's path
  };

  /// Beyond the ends the path goes on with its first or last polynomials.
  [[nodiscard]] Place at(double s) const {
    const auto next = std::upper_bound(starts_.begin() + 1, starts_.end(), s);
    const int e = static_cast<int>(next - starts_.begin()) - 1;
    const double U = curve_.rolling_time() * curve_.mesh().length(e);
    // Solve s(t) = s; ds/dt = U w. At the start s ~ t², hence the root.
    const double first = starts_[static_cast<std::size_t>(e)];
    const double last = next == starts_.end()
                            ? curve_.arc_length()
                            : starts_[static_cast<std::size_t>(e) + 1];
    double t = (s - first) / (last - first);
    if (e == 0) t = std::sqrt(std::max(t, 0.0));
    ExtremalPoint point = curve_.at(e, t);
    for (int i = 0; i < 20 && point.w > 0.0; ++i) {
      const double step = (s - point.s) / (U * point.w);
      t += step;
      point = curve_.at(e, t);
      if (std::abs(step) < 1e-15) break;
    }
    const Scene& scene = curve_.scene();
    const double rate = slope_rate(scene.body, scene.gravity,
                                   {point.theta, point.w}, point.p, point.beta);
    return {point.beta, rate / point.w};
  }

 private:
  const ExtremalCurve& curve_;
  std::vector<double> starts_;
};

// s, ṡ, x, z
using State = std::array<double, 4>;

/// The equation of motion, in time.
class Motion {
 public:
  Motion(const Scene& scene, const PathByLength& path, double start_angle)
      : scene_(scene), path_(path), start_angle_(start_angle) {}

  void operator()(const State& y, State& dy, double) const {
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
      const PathByLength::Place place = path_.at(s);
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

Reintegration reintegrate(const ExtremalCurve& curve) {
  const Scene& scene = curve.scene();
  const PathByLength path(curve);
  const Motion motion(scene, path, curve.at(0.0).beta);
  const ExtremalPoint start = curve.at(0.0);
  const ExtremalPoint end = curve.at(1.0);
  const double T = curve.transit_time();
  const double S = curve.arc_length();

  auto stepper = odeint::make_controlled(
      kTolerance, kTolerance, odeint::runge_kutta_fehlberg78<State>());
  State y{0.0, 0.0, start.centre.x, start.centre.z};
  Reintegration out;
  constexpr int kMaxSteps = 1000000;

  // In time up to just before the end …
  double t = 0.0;
  double dt = 1e-3 * T;
  const double t_stop = 0.99 * T;
  while (t < t_stop && out.steps < kMaxSteps) {
    dt = std::min(dt, t_stop - t);
    ++out.steps;
    if (stepper.try_step(motion, y, t, dt) == odeint::fail && dt < 1e-15 * T) {
      return out;
    }
    if (!(y[0] < S)) return out;
  }
  // … and in s from there, so that the last step ends at S.
  auto stepper_s = odeint::make_controlled(
      kTolerance, kTolerance, odeint::runge_kutta_fehlberg78<State>());
  const auto by_length = [&](const State& q, State& dq, double s) {
    // q = (t, ṡ, x, z)
    State rate{};
    motion({s, q[1], q[2], q[3]}, rate, 0.0);
    dq = {1.0 / q[1], rate[1] / q[1], rate[2] / q[1], rate[3] / q[1]};
  };
  State q{t, y[1], y[2], y[3]};
  double s = y[0];
  double ds = 0.1 * (S - s);
  while (s < S && out.steps < kMaxSteps) {
    ds = std::min(ds, S - s);
    ++out.steps;
    if (stepper_s.try_step(by_length, q, s, ds) == odeint::fail &&
        ds < 1e-15 * S) {
      return out;
    }
    if (!(q[1] > 0.0)) return out;
  }
  out.arrived = s >= S;
  const double v =
      end.w / std::sqrt(inertia_factor(scene.body, end.theta, end.beta));
  out.time_error = std::abs(q[0] - T) / T;
  out.speed_error = std::abs(q[1] - v) / v;
  out.position_error = std::hypot(q[2] - end.centre.x, q[3] - end.centre.z);
  if (scene.body.rolls()) {
    out.rotation_error =
        std::abs(scene.body.theta_m + S / scene.body.radius - end.theta);
  }
  return out;
}

}  // namespace brachisto
