// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brachisto::arcs {

ArcRoot find_root(const ArcSystem& system, ArcSystem::Point start,
                  const ocp::StepControl& control, int most_steps) {
  constexpr double kConverged = 1e-14, kRounding = 1e-10;
  // From there on the derivatives at hand leave so much of every residual, or
  // a small multiple, and shots without any take a fifth of the work.
  constexpr double kNear = 1e-6;
  // Those that leave more are taken anew.
  constexpr double kContracts = 0.1;
  constexpr double kSmallestFactor = 1e-3;
  ArcRoot out;
  out.point = std::move(start);
  if (!system.evaluate(out.point, control, out.at)) {
    out.at.links.clear();
    return out;
  }
  bool fresh = true;    // whether derivatives are those of the point
  bool content = true;  // with what those at hand did in the last step
  for (;; ++out.steps) {
    out.residual = out.at.largest();
    if (out.residual <= kConverged || out.steps == most_steps) break;
    ArcSystem::Linearisation there;
    if (!content && !fresh && out.residual > kRounding &&
        system.evaluate(out.point, control, there)) {
      out.at = std::exchange(there, {});
      fresh = true;
    }
    const ocp::ChainVector change = ocp::ChainElimination(out.at.links).solve();
    ArcSystem::Point trial;
    double factor = 1.0;
    const bool derivatives = out.residual > kNear;
    const auto closer = [&] {
      trial = moved(out.point, factor, change);
      return system.evaluate(trial, control, there, derivatives) &&
             there.norm() < out.at.norm();
    };
    // Rounding does not shrink by shorter steps.
    const double smallest = out.residual <= kRounding ? 1.0 : kSmallestFactor;
    bool shrinks = closer();
    while (!shrinks && fresh && 0.5 * factor >= smallest) {
      factor *= 0.5;
      shrinks = closer();
    }
    if (!shrinks && (fresh || !content || out.residual <= kRounding)) break;
    content = shrinks && there.norm() < kContracts * out.at.norm();
    if (!shrinks) continue;
    out.point = std::move(trial);
    if (derivatives) {
      out.at = std::move(there);
    } else {
      out.at.take_values(there);
    }
    fresh = derivatives;
  }
  out.converged = out.residual <= kRounding;
  return out;
}

namespace {

/// T with the first order of a change.
double corrected_time(const ArcSystem::Linearisation& at,
                      const ocp::ChainVector& change) {
  const ocp::ChainVector& by = at.time_gradient;
  double time = at.transit_time + by.globals.dot(change.globals);
  for (std::size_t i = 0; i < by.nodes.size(); ++i) {
    if (by.nodes[i].size() > 0) time += by.nodes[i].dot(change.nodes[i]);
  }
  return time;
}

/// Σ |p y|, the largest along the path: what the rounding of a state is to T.
double size_of_time(const ArcSystem::Point& point, double transit_time) {
  double largest = transit_time;
  for (const Node& node : point.nodes) {
    const Eigen::Index states = node.size() / 2;
    largest = std::max(
        largest, node.head(states).cwiseProduct(node.tail(states)).lpNorm<1>());
  }
  return largest;
}

}  // namespace

// Two steps: the first takes up what halved steps change, the second is made of
// rounding, and what it moves T by cannot be told from zero. Every step of the
// integration rounds the states, which T feels through the costates; these
// errors are independent.
//
// Derivatives are the last that find_root() took, a residual of 1e-6 off at the
// most; what a step leaves is of that order times the step.
bool refine_root(const ArcSystem& system, const ArcRoot& root,
                 const ocp::StepControl& control, RefinedRoot& out) {
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  out.point = root.point;
  out.at = root.at;
  out.transit_time = root.at.transit_time;
  double last_change = 0.0, of_all = 0.0;
  ArcSystem::Linearisation halved;
  for (int i = 0; i < 2; ++i) {
    if (!system.evaluate(out.point, {control.tolerance, true}, halved,
                         /*derivatives=*/false)) {
      return false;
    }
    out.at.take_values(halved);
    const ocp::ChainVector change = ocp::ChainElimination(out.at.links).solve();
    const double before = out.transit_time;
    out.transit_time = corrected_time(out.at, change);
    out.point = moved(out.point, 1.0, change);
    last_change = std::abs(out.transit_time - before);
    of_all += last_change;
  }
  out.error_estimate = (of_all + last_change +
                        kUlp * std::sqrt(1.0 + out.at.steps) *
                            size_of_time(out.point, out.transit_time)) /
                       out.transit_time;
  return true;
}

}  // namespace brachisto::arcs
