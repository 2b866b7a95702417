// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "extremal/arc_shooting.hpp"

#include <fmt/format.h>

#include <utility>

#include "extremal/arc_newton.hpp"

namespace brachisto {

namespace {

using arcs::ArcRoot;
using arcs::ArcSystem;
using arcs::RefinedRoot;

void read_results(const ArcSystem& system, const RefinedRoot& root,
                  LimitedExtremal& out) {
  const ocp::ChainElimination chain(root.at.links);
  ocp::ChainElimination::Functional none;
  none.nodes.resize(root.point.nodes.size());
  none.globals.setZero(root.point.globals.size());
  const auto slope_at = [&](const arcs::Jet& beta, std::size_t node) {
    ocp::ChainElimination::Functional sum = none;
    sum.nodes[node] = Eigen::Map<const Eigen::VectorXd>(
        beta.gradient.data(), root.point.nodes[node].size());
    return Loose{beta.value, chain.looseness(sum)};
  };
  out.start_angle = slope_at(root.at.slope_at_A, 0);
  out.end_angle = slope_at(root.at.slope_at_B, none.nodes.size() - 1);
  double u = 0.0;
  ocp::ChainElimination::Functional sum = none;
  for (int a = 0; a < system.num_arcs(); ++a) {
    u += root.point.globals(a);
    sum.globals(a) = 1.0;
    out.junctions.push_back({u, chain.looseness(sum)});
  }
}

void find_root(const ArcSystem& system, LimitedExtremal& out,
               ArcSystem::Point& point) {
  constexpr int kMostSteps = 30;
  const ocp::StepControl control;
  const ArcRoot root =
      arcs::find_root(system, system.start(), control, kMostSteps);
  out.newton_steps = root.steps;
  out.residual = root.residual;
  if (root.at.links.empty()) {
    out.message = fmt::format("the path nearby cannot be integrated on {}",
                              system.place_of(root.at.arc));
    return;
  }
  if (!root.converged) {
    out.message = fmt::format(
        "Newton's method stops at the residual {:.1e} after {} steps, of the "
        "conditions for {}",
        out.residual, out.newton_steps,
        system.place_of(system.arc_of_node(root.at.worst_node())));
    return;
  }
  RefinedRoot refined;
  if (!arcs::refine_root(system, root, control, refined)) {
    out.message = "the solution cannot be integrated again";
    return;
  }
  out.transit_time = refined.transit_time;
  out.error_estimate = refined.error_estimate;
  out.integration_steps = refined.at.steps;
  read_results(system, refined, out);
  point = std::move(refined.point);
  out.solved = true;
}

}  // namespace

LimitedExtremal solve_limited_extremal(const Scene& natural,
                                       const arcs::Guess& guess,
                                       const StopCondition& stop) {
  const StopScope scope(stop);
  LimitedExtremal out;
  const ArcSystem system(natural, guess);
  if (!system.refusal().empty()) {
    out.message = "arcs of this kind are not known to it: " + system.refusal();
    return out;
  }
  try {
    ArcSystem::Point point;
    find_root(system, out, point);
    if (!out.solved) return out;
    out.path = system.path(point, {.halve = true});
    // The first node is not at rest then.
    if (out.path.blind(0)) {
      out.start_angle.value = out.path.at(0, 0.0).y[arcs::kBeta];
    }
    const std::string objection =
        out.path.empty()
            ? "it cannot be integrated again"
            : out.path.objection(inequalities(natural.body, natural.limits));
    if (!objection.empty()) {
      out.solved = false;
      out.message = "its arcs are not those of an extremal: " + objection;
    }
  } catch (const Stopped&) {
    if (!stop.met()) throw;
    out.solved = false;
    out.message = "stopped within an arc";
  }
  return out;
}

}  // namespace brachisto
