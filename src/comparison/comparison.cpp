// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brachisto/io/diagnostics.hpp"
#include "comparison/methods.hpp"
#include "io/input_tree.hpp"

namespace brachisto::comparison {

namespace {

using Kind = ComparedMethod::Kind;

struct Contender {
  std::string label;
  std::vector<std::string> overrides;
  bool discrete_system = false;
  bool nonlinear_program = false;
};

Contender contender(const ComparedMethod& method, int mesh,
                    const Subject& subject) {
  return {label(method), overrides(method, mesh, subject.problem),
          method.kind == Kind::Fsolve,
          method.kind == Kind::RollingTime || method.kind == Kind::ArcLength};
}

/// In the order of the table; the first one is the extremal method.
std::vector<Contender> contenders(const Subject& subject, int nodes) {
  constexpr int kDegree = 5;
  std::vector<Contender> all{contender({.kind = Kind::Extremal}, 0, subject)};
  // On the mesh that the wanted accuracy asks for, not on one with n nodes.
  Contender by_tolerance = contender(rolling_time(kDegree), 1, subject);
  by_tolerance.label = "rolling_time";
  by_tolerance.overrides.emplace_back("discretisation={}");
  all.push_back(by_tolerance);
  all.push_back(contender(rolling_time(kDegree),
                          std::max(1, (nodes - 1) / kDegree), subject));
  if (accepts("solver.method", "newton_kkt")) {
    Contender newton = all.back();
    newton.label += ", newton";
    newton.overrides.emplace_back("solver.method=newton_kkt");
    all.push_back(newton);
  }
  const ComparedMethod pieces{.kind = Kind::ArcLength};
  if (available(pieces)) all.push_back(contender(pieces, nodes - 1, subject));
  for (const FsolveArm arm : {FsolveArm::Rest, FsolveArm::Release,
                              FsolveArm::Newton, FsolveArm::Lifted}) {
    all.push_back(contender(fsolve(arm), nodes, subject));
  }
  return all;
}

}  // namespace

Subject read_subject(const std::string& file,
                     const std::vector<std::string>& overrides) {
  if (file == io::kStandardInput) {
    throw io::IoError(
        "-: every method reads the problem anew; expected the name of a file");
  }
  Subject subject{file, overrides, io::read_problem_file(file, overrides)};
  if (subject.problem.scene.path) {
    throw io::InputError(
        {{file, 0, 0, "scene.path",
          "nothing is sought on a given path, so that there are no methods to "
          "compare; leave it out"}});
  }
  return subject;
}

std::optional<Reference> reference_in(const Measurement& extremal) {
  if (!extremal.solved() || !extremal.verified || !extremal.estimated_error) {
    return std::nullopt;
  }
  return Reference{extremal.tau, *extremal.estimated_error, extremal.path};
}

double error_of(const Measurement& run, const Reference& reference) {
  return std::abs(run.tau / reference.tau - 1.0);
}

std::string verdict(const ComparisonRow& row) {
  if (!row.run.solved()) {
    return std::string(name(row.run.outcome)) + ": " + row.run.cause;
  }
  if (row.run.verified) return "verified";
  return row.discrete_system ? "solved, first-order conditions"
                             : "solved, not verified: " + row.run.cause;
}

MethodComparison compare_methods(const Subject& subject,
                                 const ComparisonOptions& options,
                                 const Hooks& hooks) {
  MethodComparison out{subject, options, {}, {}};
  for (const Contender& one : contenders(subject, options.nodes)) {
    if (hooks.announce) hooks.announce(one.label);
    Experiment experiment{subject.file, subject.overrides, options.repetitions,
                          options.seconds, options.residual};
    experiment.overrides.insert(experiment.overrides.end(),
                                one.overrides.begin(), one.overrides.end());
    if (one.nonlinear_program) {
      experiment.overrides.push_back(
          fmt::format("solver.tolerance={}", options.residual));
    }
    ComparisonRow row{one.label, one.discrete_system,
                      measure(experiment, hooks.interrupt), std::nullopt};
    if (out.rows.empty()) out.reference = reference_in(row.run);
    if (out.reference && row.run.solved()) {
      row.error = error_of(row.run, *out.reference);
    }
    out.rows.push_back(std::move(row));
  }
  return out;
}

}  // namespace brachisto::comparison
