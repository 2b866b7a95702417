// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "comparison/methods.hpp"
#include "study/pose.hpp"

namespace brachisto::comparison {

namespace {

using Kind = ComparedMethod::Kind;

struct Contender {
  std::string label;
  ComparedMethod method;
  SolveOptions options;
};

/// In the order of the table, after the referees.
std::vector<Contender> contenders(const Subject& subject, int nodes,
                                  double residual) {
  constexpr int kDegree = 5;
  const int elements = std::max(1, (nodes - 1) / kDegree);
  const SolveOptions& base = subject.problem.options;
  const auto contender = [&](const ComparedMethod& method,
                             const Fineness& fineness) {
    SolveOptions options = options_of(method, fineness, base);
    if (auto* program = std::get_if<Collocation>(&options.method)) {
      program->tolerance = residual;
    } else if (auto* system = std::get_if<DiscreteSystem>(&options.method)) {
      system->tolerance = residual;
    }
    return Contender{label(method), method, std::move(options)};
  };
  // On the mesh that the wanted accuracy asks for, not on one with n nodes.
  Contender by_tolerance = contender({.kind = Kind::Adaptive}, {});
  by_tolerance.label = "rolling_time";
  Contender newton = contender(rolling_time(kDegree), {.mesh = elements});
  newton.label += ", newton";
  newton.options.use<Collocation>().solver = ProgramSolver::NewtonKkt;
  std::vector<Contender> all{
      std::move(by_tolerance),
      contender(rolling_time(kDegree), {.mesh = elements}), std::move(newton)};
  all.push_back(contender({.kind = Kind::ArcLength}, {.mesh = nodes - 1}));
  for (const DiscreteArm arm : {DiscreteArm::Rest, DiscreteArm::Release,
                                DiscreteArm::Newton, DiscreteArm::Lifted}) {
    all.push_back(contender(discrete_system(arm), {.mesh = nodes}));
  }
  return all;
}

}  // namespace

Subject read_subject(const std::string& file,
                     const std::vector<std::string>& overrides) {
  check_named(file);
  Subject subject{file, overrides, io::read_problem_file(file, overrides)};
  if (subject.problem.scene.path) {
    throw io::InputError(
        {{file, 0, 0, "scene.path",
          "nothing is sought on a given path, so that there are no methods to "
          "compare; leave it out"}});
  }
  return subject;
}

bool Subject::limited() const {
  return is_limited(problem.scene);
}

FoundReference find_reference(
    const Subject& subject,
    const std::function<Measurement(const Referee&)>& run) {
  constexpr double kTolerance = 1e-12;
  std::vector<Referee> referees{
      {{.kind = Kind::Extremal}, {}, "the extremal method"}};
  if (subject.limited()) {
    referees.push_back(
        {{.kind = Kind::Adaptive}, kTolerance, "rolling_time to 1e-12"});
  }
  FoundReference found;
  for (const Referee& referee : referees) {
    const Measurement made = run(referee);
    found.reference = referee.reference_in(made);
    if (found.reference) {
      found.reference->instead_of = found.why_not;
      break;
    }
    found.why_not += fmt::format(
        "{}{} {}: {}", found.why_not.empty() ? "" : "; ", referee.name,
        made.solved() ? "is not verified" : name(made.outcome), made.cause);
  }
  return found;
}

std::optional<Reference> Referee::reference_in(const Measurement& run) const {
  if (!run.solved() || !run.verified || !run.estimated_error) {
    return std::nullopt;
  }
  return Reference{run.tau, *run.estimated_error, run.path, name, method};
}

double error_of(const Measurement& run, const Reference& reference) {
  return std::abs(run.tau / reference.tau - 1.0);
}

std::string verdict(const ComparisonRow& row) {
  if (!row.run.solved()) {
    return std::string(name(row.run.outcome)) + ": " + row.run.cause;
  }
  if (row.run.verified) return "verified";
  return row.method.kind == Kind::DiscreteSystem
             ? "solved, first-order conditions"
             : "solved, not verified: " + row.run.cause;
}

MethodComparison compare_methods(const Subject& subject,
                                 const ComparisonOptions& options,
                                 const Hooks& hooks) {
  MethodComparison out{subject, options, {}, {}};
  const auto run = [&](const std::string& label, const ComparedMethod& method,
                       const SolveOptions& with) {
    if (hooks.announce) hooks.announce(label);
    out.rows.push_back({label, method,
                        measure({subject.file, subject.overrides, with,
                                 options.repetitions, options.seconds},
                                hooks.interrupt)});
    return out.rows.back().run;
  };
  out.reference =
      find_reference(subject, [&](const Referee& referee) {
        return run(referee.tolerance ? referee.name : label(referee.method),
                   referee.method,
                   options_of(referee.method, {.tolerance = referee.tolerance},
                              subject.problem.options));
      }).reference;
  for (const Contender& one :
       contenders(subject, options.nodes, options.residual)) {
    (void)run(one.label, one.method, one.options);
  }
  for (ComparisonRow& row : out.rows) {
    if (out.reference && row.run.solved()) {
      row.error = error_of(row.run, *out.reference);
    }
  }
  return out;
}

}  // namespace brachisto::comparison
