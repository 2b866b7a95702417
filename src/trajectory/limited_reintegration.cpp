// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>

#include "brachisto/math/stop_condition.hpp"
#include "model/energy.hpp"
#include "model/field.hpp"
#include "model/inertia.hpp"
#include "trajectory/acceleration.hpp"
#include "trajectory/reintegration.hpp"

namespace brachisto {

namespace {

namespace odeint = boost::numeric::odeint;

// Of the integrator, absolute and relative; ten times rounding.
constexpr double kTolerance = 1e-14;

}  // namespace

LimitedReintegration reintegrate(const LimitedCurve& curve) {
  // t, ṡ, s, x, z along the place in an element.
  using Along = std::array<double, 5>;
  // Copied before it has computed anything; being static it holds zeros then.
  static const odeint::runge_kutta_fehlberg78<Along> kFreshStepper;
  const LimitedTime& problem = curve.problem();
  const Scene& scene = problem.scene();
  const CollocationScheme& scheme = problem.scheme();
  const bool pushed = problem.pushed();
  const double begin = pushed ? 0.0 : scheme.rule.points.front();
  const TurningPoint<double> rest = curve.at(0, 0.0).state;
  // Up to there along the same slopes as behind, for so little has been fallen
  // that a place's own error would be a great part of it.
  const math::QuadratureRule rule = math::gauss_legendre(scheme.degree + 1);
  double h = problem.mesh().length(0) * curve.rolling_time();
  double fallen = 0.0, work = 0.0;
  Along y{0.0, 0.0, 0.0, rest.x, rest.z};
  for (std::size_t i = 0; i < rule.points.size(); ++i) {
    const auto at = curve.at(0, begin * rule.points[i]).state;
    const double du = h * begin * rule.weights[i];
    y[0] += du * std::sqrt(inertia_factor(scene.body, at.theta, at.beta));
    y[2] += du * at.w;
    y[3] += du * at.w * std::cos(at.beta);
    fallen += du * at.w * std::sin(at.beta);
    work += du * at.w * speed_gain(scene, at);
  }
  y[4] += fallen;
  const TurningPoint<double> first = curve.at(0, begin).state;
  const double w =
      pushed ? first.w
      : scene.world.changes_rates()
          ? std::sqrt(2.0 * work)
          : fall_speed(scene.gravity,
                       energy_height(scene.body, fallen, first.theta));
  y[1] = w / std::sqrt(inertia_factor(scene.body, first.theta, first.beta));
  LimitedReintegration out;
  for (int e = 0; e < problem.mesh().num_elements(); ++e) {
    check_stop(e);
    h = problem.mesh().length(e) * curve.rolling_time();
    const auto look_at_limits = [&](double t) {
      TurningPoint<double> place = curve.at(e, t).state;
      place.w =
          y[1] * std::sqrt(inertia_factor(scene.body, place.theta, place.beta));
      place.x = y[3];
      place.z = y[4];
      const Excess excess = worst_excess(problem.limits(), scene, place);
      if (std::isnan(out.excess) || excess.value <= out.excess) return;
      out.excess = excess.value;
      out.excess_at = problem.mesh().sigma(e, t);
    };
    const auto rates = [&](const Along& at, Along& rate, double t) {
      const TurningPoint<double> path = curve.at(e, t).state;
      const double v = at[1];
      const double ds = h * path.w;
      const Direction along = direction_of(path.beta);
      const double v_kappa = v * path.q / path.w;
      const double s_ddot =
          acceleration(scene, at[2], v, {at[3], at[4]}, along, v_kappa);
      rate = {ds / v, s_ddot * ds / v, ds, ds * along.cosine, ds * along.sine};
    };
    double t = e == 0 ? begin : 0.0;
    double dt = 0.25;
    auto stepper =
        odeint::make_controlled(kTolerance, kTolerance, kFreshStepper);
    constexpr int kMostSteps = 10000;
    for (int step = 0; t < 1.0; ++step) {
      dt = std::min(dt, 1.0 - t);
      const bool last = dt >= 1.0 - t;
      const bool failed = stepper.try_step(rates, y, t, dt) == odeint::fail;
      if (!(y[1] > 0.0) || step > kMostSteps) {
        out.error = std::numeric_limits<double>::quiet_NaN();
        return out;
      }
      if (!failed) look_at_limits(std::min(t, 1.0));
      if (!failed && last) break;
    }
  }
  const TurningPoint<double> last = curve.at(1.0).state;
  const double speed =
      last.w / std::sqrt(inertia_factor(scene.body, last.theta, last.beta));
  const double late = std::abs(y[0] / curve.transit_time() - 1.0);
  const double faster = std::abs(y[1] / speed - 1.0);
  const double off = std::hypot(y[3] - last.x, y[4] - last.z);
  const double sum = late + faster + off;
  out.error = std::isnan(sum) ? sum : std::max({late, faster, off});
  return out;
}

}  // namespace brachisto
