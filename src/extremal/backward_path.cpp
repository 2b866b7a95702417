// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/backward_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "extremal/adaptive_integration.hpp"
#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto::shooting {

BackwardShooting::BackwardShooting(const Scene& natural, double longest)
    : scene_(natural),
      longest_(longest),
      start_(start_conditions(natural, natural.body.eta_m)) {}

std::optional<InitialCondition> BackwardShooting::shoot(
    const TerminalCondition& terminal, double tolerance,
    BackwardPath* path) const {
  constexpr int kMostSteps = 100000;
  constexpr double kShortest = 1e-8;
  const auto& [theta, phi] = terminal;
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
  const Stack<kPath> start{end.x, end.z, theta, w, 0.0, 0.0, 0.0};
  AdaptiveIntegration back(CanonicalRates<kPath>{flow, phi, -1.0}, start);
  if (back.failed()) return std::nullopt;
  const Stack<kPath>& now = back.now();
  double u = 0.0;
  // A fraction of a radian of the rolling, also where w is yet to grow.
  double step = 0.3 * r / (w + std::sqrt(r));
  if (path != nullptr) path->knots.push_back(knot_at(u, now, back.rates().beta));
  for (int i = 0; now[kW] > 0.0; ++i) {
    ++steps_;
    const bool taken = back.step(step, tolerance);
    if (i == kMostSteps) return std::nullopt;
    if (taken) u += step;
    step *= back.factor();
    if (!taken) {
      if (step < kShortest) return std::nullopt;
      continue;
    }
    const double left = longest_ - r * (theta - now[kTheta]);
    if (back.failed() || std::abs(back.rates().beta) > std::numbers::pi ||
        std::abs(now[kX] - start_.x) > left) {
      return std::nullopt;
    }
    if (path != nullptr && now[kW] > 0.0) {
      path->knots.push_back(knot_at(u, now, back.rates().beta));
    }
  }
  // w is smooth through zero: Newton's method on u.
  for (int i = 0; i < 4; ++i) {
    const double by = -now[kW] / back.slope()[kW];
    back.step_unchecked(by);
    u += by;
  }
  if (back.failed() || !(std::abs(now[kW]) <= tolerance)) return std::nullopt;
  if (path != nullptr) {
    path->p_x = p_x;
    path->p_z = p_z;
    path->knots.push_back(knot_at(u, now, back.rates().beta));
    std::reverse(path->knots.begin(), path->knots.end());
    for (ExtremalPath::Knot& knot : path->knots) {
      knot.u = u - knot.u;
      knot.t -= now[kTime];
    }
  }
  return InitialCondition{now[kX] - start_.x, now[kTheta], -now[kTime]};
}

}  // namespace brachisto::shooting
