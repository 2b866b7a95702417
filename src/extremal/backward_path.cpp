// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/backward_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/contact.hpp"
#include "model/energy.hpp"
#include "model/inertia.hpp"

namespace brachisto {

BackwardShooting::BackwardShooting(const Scene& natural, double longest)
    : scene_(natural),
      longest_(longest),
      start_(start_of_centre(natural)),
      flow_({natural, {}, 1.0 / natural.body.radius}) {}

std::optional<InitialCondition> BackwardShooting::shoot(
    const TerminalCondition& terminal, double tolerance,
    std::vector<arcs::Knot>* path) const {
  using namespace arcs::free_arc;
  using Rates = ocp::FlowRates<Flow, false>;
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

  ocp::AdaptiveIntegration<Rates> back(
      Rates{flow_, phi},
      Rates::stack_of({end.x, end.z, theta, w, p_x, p_z, 0.0, 0.0}));
  if (back.failed()) return std::nullopt;
  const auto& now = back.now();
  double u = 0.0;
  const auto tell = [&] {
    if (path == nullptr) return;
    path->push_back({u, Eigen::Map<const arcs::Node>(now.data(), Flow::kSize),
                     now[Rates::kCost], back.rates().control});
  };
  // A fraction of a radian of the rolling, also where w is yet to grow.
  double step = 0.3 * r / (w + std::sqrt(r));
  tell();
  for (int i = 0; now[kW] > 0.0; ++i) {
    ++steps_;
    const bool taken = back.step(-step, tolerance);
    if (i == kMostSteps) return std::nullopt;
    if (taken) u += step;
    step *= back.factor();
    if (!taken) {
      if (step < kShortest) return std::nullopt;
      continue;
    }
    const double left = longest_ - r * (theta - now[kTheta]);
    if (back.failed() || std::abs(back.rates().control) > std::numbers::pi ||
        std::abs(now[kX] - start_.x) > left) {
      return std::nullopt;
    }
    if (now[kW] > 0.0) tell();
  }
  // w is smooth through zero: Newton's method on u.
  for (int i = 0; i < 4; ++i) {
    const double by = -now[kW] / back.slope()[kW];
    back.step_unchecked(by);
    u -= by;
  }
  if (back.failed() || !(std::abs(now[kW]) <= tolerance)) return std::nullopt;
  if (path != nullptr) {
    tell();
    std::reverse(path->begin(), path->end());
    for (arcs::Knot& knot : *path) {
      knot.u = u - knot.u;
      knot.t -= now[Rates::kCost];
    }
  }
  return InitialCondition{now[kX] - start_.x, now[kTheta], -now[Rates::kCost]};
}

}  // namespace brachisto
