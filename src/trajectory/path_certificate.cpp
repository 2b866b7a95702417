// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/trajectory/path_certificate.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/model/contact.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// s, ṡ
using State = std::array<double, 2>;
using Stepper = odeint::runge_kutta_fehlberg78<State>;

// Copied before it has computed anything; being static it holds zeros then.
const Stepper kFreshStepper;

/// The equation of motion on a given path, in time.
class RollingBody {
 public:
  explicit RollingBody(const PrescribedMotion& motion) : motion_(motion) {}

  void operator()(const State& y, State& dy, double) const {
    const Scene& scene = motion_.scene();
    const Body& body = scene.body;
    const double turning = body.rolls() ? 1.0 / body.radius : 0.0;
    const double s = std::clamp(y[0], 0.0, motion_.centre_path_length());
    const double theta = body.theta_m + s * turning;
    const CurvePlace place = motion_.curve().at(motion_.place_at_length(s));
    const double A = inertia_factor(body, theta, place.beta);
    // At the start v κ_c stays bounded, and so A_s v² vanishes with v.
    const double v_kappa =
        place.speed > 0.0 ? y[1] * place.turning / place.speed : 0.0;
    const double A_s_v2 = -2.0 * body.eta_m * std::cos(theta - place.beta) *
                          y[1] * (y[1] * turning - v_kappa);
    dy[0] = y[1];
    dy[1] =
        (scene.gravity * energy_slope(body, theta, place.beta) - 0.5 * A_s_v2) /
        A;
  }

 private:
  const PrescribedMotion& motion_;
};

/// How far the ends are from A and B, in x over L and in z over H.
double contact_error(const PrescribedMotion& motion) {
  const Scene& scene = motion.scene();
  const bool smooth = scene.contact == Contact::Smooth;
  const auto distance = [&](const TrajectoryPoint& at, Point wanted) {
    const Point there = smooth ? at.motion.contact : at.centre;
    return std::max(std::abs(there.x - wanted.x) / scene.L,
                    std::abs(there.z - wanted.z) / scene.H);
  };
  return std::max(distance(motion.at(0.0), {0.0, 0.0}),
                  distance(motion.at(1.0), {scene.L, scene.H}));
}

}  // namespace

double reintegration_error(const PrescribedMotion& motion, double from) {
  constexpr double kTolerance = 1e-13;
  constexpr double kFirstStep = 1e-3;
  constexpr double kShortest = 1e-15;
  constexpr double kFailed = std::numeric_limits<double>::quiet_NaN();
  const double T = motion.transit_time();
  const RollingBody body(motion);
  auto stepper = odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
  State y{0.0, 0.0};
  double t = 0.0;
  if (from > 0.0) {
    const TrajectoryPoint start = motion.at(from);
    y = {start.s, start.motion.v_c};
    t = start.t;
  }
  double dt = kFirstStep * T;
  // Cell by cell: where the curvature has kinks the steps end, for the error
  // estimate of this method does not see them.
  for (const TrajectoryPoint& cell : motion.at_nodes()) {
    while (t < cell.t) {
      check_stop();
      dt = std::min(dt, cell.t - t);
      if (stepper.try_step(body, y, t, dt) == odeint::fail &&
          dt < kShortest * T) {
        return kFailed;
      }
    }
  }
  const double v = motion.at(1.0).motion.v_c;
  const double late = std::abs(y[0] - motion.centre_path_length()) / (v * T);
  return std::max(late, std::abs(y[1] - v) / v);
}

Certificate certify_path(const PrescribedMotion& motion, double tolerance) {
  // Of the integrator, over some hundred steps.
  constexpr double kIntegrator = 1e-10;
  Certificate certificate;
  certificate.add("quadrature_error", motion.error_estimate(), tolerance);
  certificate.add("contact_error", contact_error(motion), kCloseToEnds);
  certificate.add("reintegration_error", reintegration_error(motion),
                  std::max(tolerance, kIntegrator));
  return certificate;
}

}  // namespace brachisto
