// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "comparison/measurement.hpp"
#include "comparison/methods.hpp"

namespace brachisto::comparison {

namespace {

/// Runs a method for one point.
using Run = std::function<Measurement(
    const ComparedMethod& method, const Fineness& fineness, int repetitions)>;

Reference find_reference(const Referee& referee, const Run& run) {
  const Measurement made =
      run(referee.method, {.tolerance = referee.tolerance}, 1);
  if (const auto found = referee.reference_in(made)) return *found;
  throw NoReference(fmt::format(
      "there is no reference to take errors against; {} {}: {}", referee.name,
      made.solved() ? "is not verified" : name(made.outcome), made.cause));
}

PrecisionLine line_of(const ComparedMethod& method, const WorkPrecision& all,
                      const Run& run) {
  PrecisionLine out{method, {}, {}};
  const Scene& scene = all.subject.problem.scene;
  for (const Fineness& fineness : points_of(method, all.plan)) {
    PrecisionPoint point{
        fineness, run(method, fineness, all.plan.repetitions), {}, {}};
    if (point.run.solved()) {
      point.error = error_of(point.run, all.reference);
      if (method != referee_of(all.subject).method) {
        point.path_error = path_error(point.run.path, all.reference.path,
                                      std::max(scene.L, scene.H));
      }
    }
    out.points.push_back(std::move(point));
  }
  return out;
}

std::optional<ObservedOrder> order_of(const PrecisionLine& line, double floor) {
  std::vector<SizeError> errors;
  for (const PrecisionPoint& point : line.points) {
    if (point.fineness.mesh > 0 && point.error) {
      errors.push_back(
          {static_cast<double>(point.fineness.mesh), *point.error});
    }
  }
  constexpr int kLeastMeshes = 4;
  const auto order = observed_order(errors, floor);
  return order && order->points >= kLeastMeshes ? order : std::nullopt;
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
  WorkPrecision out{
      subject, plan, find_reference(referee_of(subject), run), {}};
  for (const ComparedMethod& method : plan.methods) {
    if (subject.limited() && !takes_limits(method)) continue;
    out.lines.push_back(line_of(method, out, run));
    out.lines.back().order = order_of(out.lines.back(), out.floor());
  }
  return out;
}

}  // namespace brachisto::comparison
