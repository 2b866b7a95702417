// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/work_precision.hpp"

#include <algorithm>
#include <functional>
#include <limits>

#include "comparison/measurement.hpp"

namespace brachisto::comparison {

namespace {

/// Runs a method for one point.
using Run = std::function<Measurement(
    const ComparedMethod& method, const Fineness& fineness, int repetitions)>;

/// A method that refuses one mesh refuses the scene, and is asked no more.
PrecisionLine line_of(const ComparedMethod& method, const WorkPrecision& all,
                      const Run& run) {
  PrecisionLine out{method, {}};
  const Scene& scene = all.subject.problem.scene;
  for (const Fineness& fineness : points_of(method, all.plan)) {
    PrecisionPoint point{
        fineness, run(method, fineness, all.plan.repetitions), {}, {}};
    if (point.run.solved()) {
      point.error = error_of(point.run, all.reference);
      if (method != all.reference.method) {
        point.path_error = path_error(point.run.path, all.reference.path,
                                      std::max(scene.L, scene.H));
      }
    }
    out.points.push_back(std::move(point));
    if (out.points.back().refused()) break;
  }
  return out;
}

AsymptoticOrder order_of(const PrecisionLine& line, double floor) {
  if (!has_meshes(line.method)) return {{}, "it has no mesh of its own"};
  std::vector<SizeError> errors;
  for (const PrecisionPoint& point : line.points) {
    if (point.fineness.mesh > 0 && point.error) {
      errors.push_back(
          {static_cast<double>(point.fineness.mesh), *point.error});
    }
  }
  return asymptotic_order(errors, floor);
}

}  // namespace

double WorkPrecision::floor() const {
  constexpr double kAbove = 10.0;
  // Polishing goes on below the tolerance as far as rounding lets it; that of
  // the sums of a time is some of its last digits.
  constexpr double kRounding = 16.0 * std::numeric_limits<double>::epsilon();
  const double solver = polished() ? kRounding : tolerance();
  return kAbove * std::max(solver, reference.error);
}

WorkPrecision run_work_precision(const Subject& subject,
                                 const WorkPrecisionPlan& plan,
                                 const Hooks& hooks) {
  const Run run = [&](const ComparedMethod& method, const Fineness& fineness,
                      int repetitions) {
    if (hooks.announce) {
      const std::string point = text(fineness);
      hooks.announce(label(method) + (point.empty() ? "" : ", " + point));
    }
    return measure({subject.file, subject.overrides,
                    options_of(method, fineness, subject.problem.options),
                    repetitions, plan.seconds_per_point},
                   hooks.interrupt);
  };
  const FoundReference found =
      find_reference(subject, [&](const Referee& referee) {
        return run(referee.method, {.tolerance = referee.tolerance}, 1);
      });
  if (!found.reference) {
    throw NoReference("there is no reference to take errors against; " +
                      found.why_not);
  }
  WorkPrecision out{subject, plan, *found.reference};
  for (const ComparedMethod& method : plan.methods) {
    if (subject.limited() && method.kind == ComparedMethod::Kind::Extremal) {
      out.left_out.push_back(
          {method,
           "under limits it begins on the arcs that the program found, so that "
           "its time is not its own"});
      continue;
    }
    PrecisionLine line = line_of(method, out, run);
    if (!line.points.empty() && line.points.back().refused()) {
      out.left_out.push_back({method, line.points.back().run.cause});
      continue;
    }
    line.order = order_of(line, out.floor());
    out.lines.push_back(std::move(line));
  }
  return out;
}

}  // namespace brachisto::comparison
