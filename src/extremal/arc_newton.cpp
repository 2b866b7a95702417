// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_newton.hpp"

#include <cmath>
#include <utility>

namespace brachisto::arcs {

ArcRoot find_root(const ArcSystem& system, ArcSystem::Point start,
                  const ocp::StepControl& control, int most_steps) {
  constexpr double kConverged = 1e-14, kRounding = 1e-10;
  constexpr double kSmallestFactor = 1e-3;
  ArcRoot out;
  out.point = std::move(start);
  if (!system.evaluate(out.point, control, out.at)) {
    out.at.links.clear();
    return out;
  }
  for (;; ++out.steps) {
    out.residual = out.at.largest();
    if (out.residual <= kConverged || out.steps == most_steps) break;
    const ocp::ChainVector change = ocp::ChainElimination(out.at.links).solve();
    ArcSystem::Linearisation there;
    ArcSystem::Point trial;
    double factor = 1.0;
    const auto closer = [&] {
      trial = moved(out.point, factor, change);
      return system.evaluate(trial, control, there) &&
             there.norm() < out.at.norm();
    };
    // Rounding does not shrink by shorter steps.
    const double smallest = out.residual <= kRounding ? 1.0 : kSmallestFactor;
    bool shrinks = closer();
    while (!shrinks && 0.5 * factor >= smallest) {
      factor *= 0.5;
      shrinks = closer();
    }
    if (!shrinks) break;
    out.point = std::move(trial);
    out.at = std::move(there);
  }
  out.converged = out.residual <= kRounding;
  return out;
}

bool refine_root(const ArcSystem& system, const ArcRoot& root,
                 const ocp::StepControl& control, RefinedRoot& out) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  if (!system.evaluate(root.point, {control.tolerance, true}, out.at)) {
    return false;
  }
  const ocp::ChainVector change = ocp::ChainElimination(out.at.links).solve();
  const ocp::ChainVector& by = out.at.time_gradient;
  out.transit_time = out.at.transit_time + by.globals.dot(change.globals);
  for (std::size_t i = 0; i < by.nodes.size(); ++i) {
    if (by.nodes[i].size() > 0) {
      out.transit_time += by.nodes[i].dot(change.nodes[i]);
    }
  }
  out.error_estimate =
      std::abs(out.transit_time - root.at.transit_time) / out.transit_time +
      kUlp * std::sqrt(1.0 + out.at.steps);
  out.point = moved(root.point, 1.0, change);
  return true;
}

}  // namespace brachisto::arcs
