// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/backward_path.hpp"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "brachisto/model/contact.hpp"
#include "brachisto/model/energy.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto::shooting {

namespace {

/// States, costates and t.
using Stack = std::array<double, kStates + 1>;
using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<Stack>;

/// The flow with the sign of u turned round.
struct BackwardRates {
  const CanonicalFlow& flow;
  double beta;  ///< the last slope, near which the next one is searched
  bool failed = false;

  void operator()(const Stack& stack, Stack& rates, double) {
    State y;
    std::copy_n(stack.begin(), kStates, y.begin());
    CanonicalFlow::Slope slope;
    if (failed || !flow.find_slope(y, beta, slope)) {
      failed = true;
      rates.fill(0.0);
      return;
    }
    beta = slope.beta;
    const State forward = flow.rates(y, slope);
    std::transform(forward.begin(), forward.end(), rates.begin(),
                   std::negate<>());
    rates[kStates] = -slope.R;
  }
};

/// Largest error of a step relative to the tolerance; p_θ in units of r.
double relative_error(const Stack& error, double inverse_radius,
                      double tolerance) {
  double largest = 0.0;
  for (std::size_t i = 0; i < kStates; ++i) {
    const double weight = i == kPTheta ? inverse_radius : 1.0;
    const double ratio = std::abs(error[i]) * weight / tolerance;
    if (!std::isfinite(ratio)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, ratio);
  }
  return largest;
}

ExtremalPath::Knot knot_at(double u, const Stack& stack, double beta) {
  ExtremalPath::Knot knot{.u = u, .t = stack[kStates], .beta = beta};
  std::copy_n(stack.begin(), kStates, knot.y.begin());
  return knot;
}

}  // namespace

BackwardShooting::BackwardShooting(const Scene& natural, double longest)
    : scene_(natural),
      longest_(longest),
      start_(start_conditions(natural, natural.body.eta_m)) {}

std::optional<Release> BackwardShooting::shoot(const Arrival& arrival,
                                               double tolerance,
                                               BackwardPath* path) const {
  constexpr int kMostSteps = 100000;
  constexpr double kShortest = 1e-8;
  constexpr double kSafety = 0.9;
  constexpr double kOrder = 8.0;
  const auto& [theta, phi] = arrival;
  const Body& body = scene_.body;
  const double r = body.radius;
  const Point end = end_of_centre(scene_, phi);
  const double E = energy_height(body, end.z - start_.z, theta);
  if (!(E > 0.0)) return std::nullopt;
  const double w = fall_speed(scene_.gravity, E);
  const double root = std::sqrt(inertia_factor(body, theta, phi));
  const double along = -root / w;
  const double across = -body.eta_m * std::cos(theta - phi) / (root * w);
  const double p_x = along * std::cos(phi) - across * std::sin(phi);
  const double p_z = along * std::sin(phi) + across * std::cos(phi);

  const CanonicalFlow flow(body, scene_.gravity, {p_x, p_z, body.eta_m});
  BackwardRates rates{flow, phi};
  Stepper stepper;
  Stack now{end.x, end.z, theta, w, 0.0, 0.0, 0.0};
  Stack slope, trial, error;
  rates(now, slope, 0.0);
  if (rates.failed) return std::nullopt;
  double u = 0.0;
  // A fraction of a radian of the rolling, also where w is yet to grow.
  double step = 0.3 * r / (w + std::sqrt(r));
  if (path != nullptr) path->knots.push_back(knot_at(u, now, rates.beta));
  for (int i = 0; now[kW] > 0.0; ++i) {
    const double before = rates.beta;
    ++steps_;
    stepper.do_step(rates, now, slope, u, trial, step, error);
    const double ratio = rates.failed
                             ? std::numeric_limits<double>::infinity()
                             : relative_error(error, 1.0 / r, tolerance);
    const double factor =
        std::clamp(kSafety * std::pow(ratio, -1.0 / kOrder), 0.2, 3.0);
    if (i == kMostSteps) return std::nullopt;
    if (ratio > 1.0) {
      rates.beta = before;
      rates.failed = false;
      step *= factor;
      if (step < kShortest) return std::nullopt;
      continue;
    }
    now = trial;
    u += step;
    step *= factor;
    rates(now, slope, u);
    const double left = longest_ - r * (theta - now[kTheta]);
    if (rates.failed || std::abs(rates.beta) > std::numbers::pi ||
        std::abs(now[kX] - start_.x) > left) {
      return std::nullopt;
    }
    if (path != nullptr && now[kW] > 0.0) {
      path->knots.push_back(knot_at(u, now, rates.beta));
    }
  }
  // w is smooth through zero: Newton's method on u.
  for (int i = 0; i < 4; ++i) {
    const double by = -now[kW] / slope[kW];
    stepper.do_step(rates, now, slope, u, trial, by);
    now = trial;
    u += by;
    rates(now, slope, u);
  }
  if (rates.failed || !(std::abs(now[kW]) <= tolerance)) return std::nullopt;
  if (path != nullptr) {
    path->p_x = p_x;
    path->p_z = p_z;
    path->knots.push_back(knot_at(u, now, rates.beta));
    std::reverse(path->knots.begin(), path->knots.end());
    for (ExtremalPath::Knot& knot : path->knots) {
      knot.u = u - knot.u;
      knot.t -= now[kStates];
    }
  }
  return Release{now[kX] - start_.x, now[kTheta], -now[kStates]};
}

}  // namespace brachisto::shooting
