// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/report/result.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/angle.hpp"
#include "report/design_report.hpp"
#include "report/result_field.hpp"
#include "report/text_table.hpp"
#include "report/track_kind.hpp"
#include "study/wider_search.hpp"
#include "trajectory/grip.hpp"

namespace brachisto::report {

namespace {

/// "90.0000° down", "6.1801° up".
/// \param error  [rad]
std::string slope(double radians, double error = 2e-6) {
  return fmt::format("{}° {}",
                     within_error(std::abs(math::in_degrees(radians)),
                                  math::in_degrees(error)),
                     radians < 0.0 ? "up" : "down");
}

/// What a search finds.
std::string branch_noun(const Solution& solution) {
  const Scene& scene = solution.scene;
  return scene.limits.any()                 ? "path"
         : scene.contact == Contact::Centre ? "extremal"
                                            : "smooth contact";
}

/// What the answer is, of its kind or of several that a search found.
std::string answer_kind(const Solution& solution) {
  if (!solution.verified() || solution.branches.size() < 2) {
    return fmt::format("the {}", track_kind(solution.scene));
  }
  return fmt::format("the fastest verified{} of the {} found",
                     solution.feasible() ? " and feasible" : "",
                     counted(solution.branches.size(), branch_noun(solution)));
}

/// The condition at A and B, and where it says what the answer is.
std::string asked(const Solution& solution) {
  const Scene& scene = solution.scene;
  if (scene.path) return "the motion along the path that the scene states";
  const std::string kind = answer_kind(solution);
  if (scene.contact == Contact::Centre) return kind;
  if (scene.contact == Contact::Optimal) {
    return kind + ", its slopes at A and B free (docs/theory.md, section 11)";
  }
  if (scene.contact == Contact::EndSlope) {
    return fmt::format("{}, {} at B (docs/theory.md, section 11)", kind,
                       slope(scene.end_slope.value_or(0.0)));
  }
  const bool limited = scene.limits.any();
  if (!scene.body.rolls()) {
    return limited ? "the fastest wire from A to B under limits"
                   : "the fastest wire from A to B";
  }
  return "a track from A to B without a kink at either end: " + kind +
         (limited ? ", a root and no minimum over the slopes there "
                    "(docs/theory.md, section 11)"
                  : " (docs/theory.md, section 3)");
}

std::string contact_force(const PathDiagnostics& diagnostics) {
  const Extreme& least = diagnostics.min_normal_force;
  const Extreme& greatest = diagnostics.max_normal_force;
  std::string text = fmt::format(
      "from {:.4g}{} to {:.4g} m g at x_b = {:.4g} m", told_force(least.value),
      least.at_start ? ", its limit at the start," : "", greatest.value,
      greatest.x);
  if (least.at_start) {
    text += fmt::format("; {:.4g} or more after the first rise",
                        diagnostics.normal_force_after_rise.value);
  }
  return text;
}

/// \param of  with a motion
std::string transit_times(const Solution& of) {
  const double error = of.estimated_error.value_or(0.0);
  const double T = of.motion()->transit_time();
  const double tau = of.motion()->tau();
  return fmt::format("T = {} s, τ = T √(2g/H) = {}", with_error(T, error * T),
                     with_error(tau, error * tau));
}

void add_answer(std::string& out, const Solution& solution) {
  const Motion& path = *solution.motion();
  const PathDiagnostics& diagnostics = *solution.diagnostics;
  add_line(out, "transit time", transit_times(solution));
  add_line(out, "track",
           fmt::format("{:.6g} m long, the path of the centre {:.6g} m{}",
                       path.rail_length(), path.centre_path_length(),
                       path.rotation()
                           ? fmt::format("; the body turns {:.2f}°",
                                         math::in_degrees(*path.rotation()))
                           : ""));
  add_line(out, "slopes",
           fmt::format("{} at A, {} at B", slope(path.start_angle()),
                       slope(path.end_angle())));
  add_line(out, "contact force", contact_force(diagnostics));
  if (!solution.scene.body.rolls()) return;
  add_line(out, "grip", "least μ " + grip_in_words(diagnostics.least_grip));
  add_line(
      out, "",
      fmt::format(
          "friction needed, |R_t|/R_n: > 0.3 for {:.0f} % of the time, > 0.5 "
          "for {:.0f} %, > 1 for {:.0f} %",
          100.0 * diagnostics.friction_above_0_3,
          100.0 * diagnostics.friction_above_0_5,
          100.0 * diagnostics.friction_above_1));
}

/// What each bound of the scene means for the path.
void add_limits(std::string& out, const Solution& solution) {
  if (solution.limits.empty()) return;
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4g}", *value) : "—";
  };
  Rows rows{{"limit", "bound", "of the time", "least slack", "dτ/d(bound)",
             "contacts held", "active at x_b [m]"}};
  for (const LimitOnPath& limit : solution.limits) {
    std::vector<std::string> arcs;
    for (const ActiveArc& arc : limit.active) {
      arcs.push_back(fmt::format("{:.4g} to {:.4g}", arc.x.from, arc.x.to));
    }
    rows.push_back(
        {limit.name, number(limit.bound),
         fmt::format("{:.0f} %", 100.0 * limit.share_of_time),
         number(limit.least_slack), number(limit.price),
         number(limit.price_at_fixed_contacts),
         arcs.empty() ? "nowhere" : fmt::format("{}", fmt::join(arcs, ", "))});
  }
  add_table(out, "limits", rows);
}

/// "1 mm", of tracks some metres long; a decimal number of metres.
double small_length(const Scene& scene) {
  constexpr double kShare = 1e-3;
  return std::pow(10.0,
                  std::floor(std::log10(kShare * std::max(scene.L, scene.H))));
}
std::string length_in_words(double metres) {
  return metres >= 1.0    ? fmt::format("{:g} m", metres)
         : metres >= 1e-3 ? fmt::format("{:g} mm", 1e3 * metres)
                          : fmt::format("{:g} µm", 1e6 * metres);
}

/// What small changes of the scene do to T, and the derivatives of τ.
void add_sensitivities(std::string& out, const Solution& solution) {
  const bool asked = solution.options.or_default<Collocation>().sensitivities !=
                     SensitivityOrder::None;
  if (asked && !solution.sensitivities) {
    add_line(
        out, "sensitivities",
        "none: the conditions of the answer are singular, its arcs are not "
        "known, or turns of a uniform body are too many to resolve");
  }
  if (!solution.sensitivities) return;
  const Scene& scene = solution.scene;
  const double length = small_length(scene);
  const std::string piece = length_in_words(length);
  struct Change {
    SceneParameter parameter;
    double by;
    std::string words;
  };
  const Change changes[] = {
      {SceneParameter::EtaM, length / scene.body.outer_radius(),
       piece + " more offset (η_m)"},
      {SceneParameter::ThetaM, std::numbers::pi / 180.0, "1° more θ_m"},
      {SceneParameter::K, 0.01, "0.01 more k"},
      {SceneParameter::Radius, length, piece + " more radius (r)"},
      {SceneParameter::L, length, piece + " more L"},
      {SceneParameter::H, length, piece + " more H"}};
  Rows rows{
      {"change", "T [ms]", "contacts held", "dτ/d(number)", "contacts held"}};
  for (const Change& change : changes) {
    const TimeDerivatives& by = solution.sensitivities->by[change.parameter];
    if (std::isnan(by.tau)) continue;
    const double milliseconds = 1e3 * change.by;
    rows.push_back(
        {change.words, fmt::format("{:+.3g}", milliseconds * by.transit_time),
         fmt::format("{:+.3g}",
                     milliseconds * by.transit_time_at_fixed_contacts),
         fmt::format("{:.6g}", by.tau),
         fmt::format("{:.6g}", by.tau_at_fixed_contacts)});
  }
  add_table(out, "sensitivities", rows);
}

/// Whether the design is of a body that has no grip enough.
bool lacks_grip(const DesignAnswer* design) {
  return design != nullptr && design->plan.max_grip && !design->best &&
         !design->minima.empty() &&
         std::ranges::none_of(design->minima, &DesignMinimum::feasible);
}

/// "verified: 16 of 16 checks, degree 6 against 7 on 9 elements agree to 9e-12;
/// feasible".
std::string verdict(const Solution& solution, const DesignAnswer* design) {
  if (solution.status != Status::Solved) return "NOT SOLVED";
  const std::vector<Check>& checks = solution.certificate.checks;
  const auto passed = std::ranges::count_if(checks, &Check::passed);
  const bool verified = solution.verified();
  std::string text =
      fmt::format("{}: {} of {} checks", verified ? "verified" : "NOT VERIFIED",
                  passed, checks.size());
  if (!verified) return text;
  const Check* agreement = solution.certificate.find("agreement");
  if (agreement != nullptr) {
    text +=
        fmt::format(", {} agree to {:.0e}", agreement->where, agreement->value);
  }
  return text + (!solution.feasible() ? "; INFEASIBLE"
                 : lacks_grip(design)
                     ? "; INFEASIBLE for want of the grip that is asked for"
                 : solution.undecided_because().empty()
                     ? "; feasible"
                     : "; feasible within the error of this mesh");
}

void add_verdict(std::string& out, const Solution& solution,
                 const DesignAnswer* design) {
  add_line(out, "verdict", verdict(solution, design));
  if (solution.verified()) {
    for (const std::string& reason : solution.infeasible_because()) {
      add_line(out, "", reason);
    }
    for (const std::string& reason : solution.undecided_because()) {
      add_line(out, "undecided", reason);
    }
  }
  if (solution.status != Status::Solved) {
    add_line(out, "", std::string(describe(solution.status)));
    add_line(out, "because", solution.message);
  }
  if (solution.relaxed) {
    const Solution& looser = *solution.relaxed;
    std::vector<std::string> bounds;
    for (const LimitOnPath& limit : looser.limits) {
      bounds.push_back(limit.bound
                           ? fmt::format("{} {:.7g}", limit.name, *limit.bound)
                           : limit.name + " farther off");
    }
    add_line(out, "looser limits",
             fmt::format("verified with {}: {}", fmt::join(bounds, ", "),
                         transit_times(looser)));
  }
  for (const std::string& reason : solution.not_verified_because()) {
    add_line(out, "failed check", reason);
  }
}

void add_cross_check(std::string& out, const Solution& solution) {
  if (!solution.extremal) return;
  const CrossCheck& check = *solution.extremal;
  const std::string of_arcs =
      check.of_slopes && check.of_junctions
          ? fmt::format(
                ", {:.0e} rad of slopes at A and B, {:.0e} U of "
                "junctions",
                *check.of_slopes, *check.of_junctions)
          : "";
  add_line(
      out, "cross-check",
      check.solved
          ? fmt::format("τ = {} by multiple shooting, relative difference "
                        "{:.0e}{}",
                        with_error(check.tau, check.error_estimate * check.tau),
                        check.difference, of_arcs)
          : "none: " + check.message);
}

/// Not under the answer's label: it is the answer to another problem.
void add_discrete_system(std::string& out, const Solution& solution) {
  if (!solution.discrete()) return;
  const DiscreteAnswer& answer = *solution.discrete();
  add_line(out, "discrete system",
           fmt::format("{} nodes, {} unknowns, ‖F‖ = {:.1e}, {} evaluations, "
                       "{:.3f} s CPU",
                       answer.nodes, answer.unknowns, answer.residual,
                       answer.evaluations, answer.cpu_seconds));
  if (!answer.solved()) return;
  // What its distance from the extremal in τ leaves of its numbers.
  constexpr double kNotCompared = 1e-6;
  const double error = solution.extremal && solution.extremal->solved
                           ? std::abs(answer.tau / solution.extremal->tau - 1.0)
                           : kNotCompared;
  add_line(
      out, "",
      fmt::format("its τ = {}, S = {} m, {} at the first node, {} at the last",
                  within_error(answer.tau, error * answer.tau),
                  within_error(answer.centre_path_length,
                               error * answer.centre_path_length),
                  slope(answer.start_angle, error),
                  slope(answer.end_angle, error)));
}

void add_branches(std::string& out, const Solution& solution) {
  const double answer = solution.verified()
                            ? solution.motion()->tau()
                            : std::numeric_limits<double>::infinity();
  const std::string labels = branch_noun(solution) + "s";
  std::string_view label = labels;
  for (const Branch& branch : solution.branches) {
    add_line(out, label,
             fmt::format(
                 "τ = {}, {} at B{}{}{}{}",
                 within_error(branch.tau, branch.estimated_error * branch.tau),
                 slope(branch.end_angle), branch.principal ? ", principal" : "",
                 branch.verified ? "" : ", NOT VERIFIED",
                 branch.minimum ? "" : ", not a minimum",
                 branch.feasible ? ", feasible" : ", INFEASIBLE"));
    label = "";
    if (branch.tau >= answer) continue;
    for (const std::string& why : branch.remarks) add_line(out, "", "  " + why);
  }
  if (!solution.search_remark.empty()) {
    add_line(out, label, solution.search_remark);
  }
}

/// From where, by whom, on how large a problem, in what time.
std::string found(const Solution& solution) {
  const Effort& effort = solution.effort;
  std::vector<std::string> parts;
  if (solution.scene.path) parts.emplace_back("evaluated, not optimised");
  if (!effort.continuation.empty()) {
    // The first is the cycloid or a neighbour, where there is nothing to do.
    const ContinuationStep& first = effort.continuation.front();
    parts.push_back(fmt::format(
        "from {} in {}", first.eta_m == 0.0 ? "the cycloid" : "a neighbour",
        counted(effort.continuation.size() - 1, "step")));
  }
  if (const auto L = solution.continued_from_L) {
    parts.push_back(fmt::format(
        "from L = {:.6g} m back in L, for here no branch is principal: the "
        "uniform cylinder has no path to B",
        *L));
  }
  if (!solution.folds.empty()) {
    parts.push_back(fmt::format(
        "beyond {} of that branch, the first at η_m = {:.6f}",
        counted(solution.folds.size(), "fold"), solution.folds.front()));
  }
  if (effort.iterations > 0) {
    parts.push_back(fmt::format(
        "{} of {}",
        counted(static_cast<std::size_t>(effort.iterations), "iteration"),
        solution.discrete()               ? "its solver"
        : solution.options.of<Shooting>() ? "Ipopt to find which arcs there are"
                                          : "Ipopt"));
  }
  if (effort.newton_steps > 0) {
    parts.push_back(
        counted(static_cast<std::size_t>(effort.newton_steps), "step") +
        " of Newton's method");
  }
  if (const ProgramSize* program = solution.program()) {
    parts.push_back(fmt::format("{} nodes, {} variables, {} constraints",
                                program->nodes, program->variables,
                                program->constraints));
  }
  parts.push_back(fmt::format("{:.3f} s", effort.seconds));
  return fmt::format("{}", fmt::join(parts, "; "));
}

/// Whether Ipopt had to do without the chain though it was not told to.
bool fell_back(const Solution& solution) {
  const auto* program = solution.options.of<Collocation>();
  return program != nullptr && program->linear_solver != LinearSolver::Mumps &&
         solution.effort.final_mesh().linear_solver == LinearSolver::Mumps;
}

/// What one would do now.
std::string next(const Solution& solution, bool designed) {
  const std::string advice = solution.advice();
  if (!advice.empty()) return advice;
  if (!solution.verified() || solution.scene.path) return {};
  // Another method is tried without limits alone.
  const bool limited = solution.scene.limits.any();
  if (!solution.feasible()) {
    // The body of a design is what it has chosen.
    if (designed) return {};
    const std::string other = solution.scene.body.off_centred()
                                  ? "a smaller eta_m, or a nearer point B"
                                  : "a nearer point B";
    const std::string search = wider_search(solution.scene, solution.options);
    return search.empty()
               ? other
               : fmt::format("solver.{}, for another {} may be feasible; {}",
                             search, branch_noun(solution), other);
  }
  if (!solution.undecided_because().empty()) {
    return "a finer mesh, which decides whether the track is feasible";
  }
  return solution.options.of<Shooting>() != nullptr || solution.extremal ||
                 solution.proof || limited
             ? ""
             : "--certify extremal checks it by another method";
}

}  // namespace

std::string summary(const Solution& solution, const DesignAnswer* design) {
  std::string out = in_words(solution.scene) + "\n";
  add_line(out, "asked", asked(solution));
  if (solution.verified()) {
    add_answer(out, solution);
    add_limits(out, solution);
    add_sensitivities(out, solution);
  }
  add_verdict(out, solution, design);
  add_cross_check(out, solution);
  if (solution.proof) add_line(out, "proof", in_words(*solution.proof));
  add_discrete_system(out, solution);
  add_branches(out, solution);
  if (design != nullptr) add_design(out, *design);
  add_line(out, solution.status == Status::Solved ? "found" : "tried",
           found(solution));
  if (fell_back(solution)) {
    add_line(out, "linear solver",
             "MUMPS in place of the chain; --verbose says why");
  }
  if (const std::string what = next(solution, design != nullptr);
      !what.empty()) {
    add_line(out, "to try", what);
  }
  return out;
}

}  // namespace brachisto::report
