// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/summary.hpp"

#include <fmt/format.h>

#include <iterator>
#include <limits>
#include <numbers>

#include "report/track_kind.hpp"

namespace brachisto::report {

namespace {

double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

void line(std::string& out, std::string_view label, const std::string& text) {
  fmt::format_to(std::back_inserter(out), "  {:<16} {}\n", label, text);
}

/// What the answer is, and where it says what that means.
std::string describe_track(const Solution& solution) {
  std::string text(track_kind(solution.scene));
  const Scene& scene = solution.scene;
  if (scene.path || !scene.body.rolls() || scene.contact == Contact::Centre) {
    return text;
  }
  if (solution.options.searches()) {
    text = fmt::format("{} of the {} smooth contact{} found",
                       solution.feasible() ? "fastest verified and feasible"
                                           : "fastest verified",
                       solution.branches.size(),
                       solution.branches.size() == 1 ? "" : "s");
  }
  return text + " (docs/theory.md, section 3)";
}

void add_answer(std::string& out, const Solution& solution) {
  const Motion& path = *solution.motion();
  const PathDiagnostics& diagnostics = *solution.diagnostics;
  line(out, "track", describe_track(solution));
  line(out, "τ = T √(2g/H)",
       fmt::format("{:.12f}   (relative error about {:.0e})", path.tau(),
                   solution.estimated_error.value_or(0.0)));
  line(out, "transit time T", fmt::format("{:.12g} s", path.transit_time()));
  line(out, "path lengths",
       fmt::format("centre {:.10g} m, track {:.10g} m",
                   path.centre_path_length(), path.rail_length()));
  line(out, "slope angles",
       fmt::format("start {:.6f}°, end {:.6f}°", degrees(path.start_angle()),
                   degrees(path.end_angle())));
  if (path.rotation()) {
    line(out, "rotation", fmt::format("{:.6f}°", degrees(*path.rotation())));
  }
  const Extreme& least = diagnostics.min_normal_force;
  std::string force = fmt::format(
      "from {:.4g}{} to {:.4g} m g at x_b = {:.4g} m", least.value,
      least.at_start ? ", its limit at the start," : "",
      diagnostics.max_normal_force.value, diagnostics.max_normal_force.x);
  if (least.at_start) {
    force += fmt::format("; {:.4g} or more after the first rise",
                         diagnostics.normal_force_after_rise.value);
  }
  line(out, "normal force", force);
  if (!solution.scene.body.rolls()) return;
  line(out, "friction needed",
       fmt::format("|R_t|/R_n > 0.3 for {:.0f} % of the time, > 0.5 for {:.0f} "
                   "%, > 1 for {:.0f} %",
                   100.0 * diagnostics.friction_above_0_3,
                   100.0 * diagnostics.friction_above_0_5,
                   100.0 * diagnostics.friction_above_1));
}

void add_second_opinion(std::string& out, const Solution& solution) {
  if (!solution.extremal) return;
  const CrossCheck& opinion = *solution.extremal;
  line(
      out, "second opinion",
      opinion.solved
          ? fmt::format("τ = {:.14g} by shooting (error about {:.0e}), "
                        "relative difference {:.1e}",
                        opinion.tau, opinion.error_estimate, opinion.difference)
          : "none: " + opinion.message);
}

/// Not under the answer's label: it is the answer to another problem.
void add_discrete_system(std::string& out, const Solution& solution) {
  if (!solution.discrete()) return;
  const DiscreteAnswer& answer = *solution.discrete();
  line(out, "discrete system",
       fmt::format("{} nodes, {} unknowns, ‖F‖ = {:.1e}, {} evaluations, "
                   "{:.3f} s CPU",
                   answer.nodes, answer.unknowns, answer.residual,
                   answer.evaluations, answer.cpu_seconds));
  if (!answer.solved()) return;
  line(out, "",
       fmt::format("its τ = {:.6f}, S = {:.6f} m, start {:.4f}°, end {:.4f}°",
                   answer.tau, answer.centre_path_length,
                   degrees(answer.start_angle), degrees(answer.end_angle)));
}

void add_branches(std::string& out, const Solution& solution) {
  const double answer = solution.verified()
                            ? solution.motion()->tau()
                            : std::numeric_limits<double>::infinity();
  std::string_view label = "smooth contacts";
  for (const Branch& branch : solution.branches) {
    std::string text = fmt::format(
        "τ = {:.10f}, end {:.4f}°{}{}{}{}", branch.tau,
        degrees(branch.end_angle), branch.principal ? ", principal" : "",
        branch.verified ? "" : ", NOT VERIFIED",
        branch.minimum ? "" : ", not a minimum",
        branch.feasible ? ", feasible" : ", INFEASIBLE");
    line(out, label, text);
    label = "";
    if (branch.tau >= answer) continue;
    for (const std::string& why : branch.remarks) line(out, "", "  " + why);
  }
  if (!solution.search_remark.empty()) {
    line(out, label, solution.search_remark);
  }
}

}  // namespace

std::string summary(const Solution& solution) {
  std::string out = in_words(solution.scene) + "\n";
  const bool verified = solution.verified();
  if (verified) add_answer(out, solution);

  std::string verdict = verified ? "verified" : "NOT VERIFIED";
  if (solution.status != Status::Solved) verdict = "NOT SOLVED";
  if (verified) verdict += solution.feasible() ? ", feasible" : ", INFEASIBLE";
  line(out, "verdict", verdict);
  if (verified) {
    for (const std::string& reason : solution.infeasible_because()) {
      line(out, "", reason);
    }
  }
  if (solution.status != Status::Solved) {
    line(out, "", std::string(describe(solution.status)));
    line(out, "because", solution.message);
  }
  for (const std::string& reason : solution.not_verified_because()) {
    line(out, "failed check", reason);
  }
  const std::string advice = solution.advice();
  if (!advice.empty()) line(out, "to try", advice);

  if (!solution.folds.empty()) {
    line(out, "branch",
         fmt::format("beyond {} fold{} of the branch from the cycloid, the "
                     "first at η_m = {:.6f}",
                     solution.folds.size(),
                     solution.folds.size() == 1 ? "" : "s",
                     solution.folds.front()));
  }
  add_discrete_system(out, solution);
  add_second_opinion(out, solution);
  add_branches(out, solution);
  const Effort& effort = solution.effort;
  const ProgramSize* program = solution.program();
  if (const Trajectory* found = solution.trajectory()) {
    const Mesh& mesh = found->curve().mesh();
    line(out, "mesh",
         fmt::format("degree {}, {} elements, {} nodes; {} variables, {} "
                     "constraints",
                     mesh.degree, mesh.num_elements(), program->nodes,
                     program->variables, program->constraints));
  } else if (program != nullptr) {
    line(out, "mesh",
         fmt::format("{} straight pieces; {} variables, {} constraints",
                     program->nodes - 1, program->variables,
                     program->constraints));
  }
  line(out, "work",
       fmt::format("{} {} iterations in {} passes, {} Newton steps, {:.3f} s",
                   effort.iterations, solution.discrete() ? "solver" : "Ipopt",
                   effort.passes, effort.newton_steps, effort.seconds));
  return out;
}

}  // namespace brachisto::report
