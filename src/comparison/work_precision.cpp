// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/work_precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "comparison/methods.hpp"
#include "comparison/path_error.hpp"

namespace brachisto::comparison {

namespace {

/// Runs a method on one mesh.
using Run = std::function<Measurement(const ComparedMethod& method, int mesh,
                                      int repetitions)>;

Reference find_reference(const Run& run) {
  const Measurement extremal =
      run({.kind = ComparedMethod::Kind::Extremal}, 0, 1);
  if (const auto found = reference_in(extremal)) return *found;
  throw NoReference(fmt::format(
      "there is no reference to take errors against; the "
      "extremal method {}: {}",
      extremal.solved() ? "is not verified" : name(extremal.outcome),
      extremal.cause));
}

PrecisionLine line_of(const ComparedMethod& method, const WorkPrecision& all,
                      const Run& run) {
  PrecisionLine out{method, {}, {}};
  const Scene& scene = all.subject.problem.scene;
  const std::vector<int> meshes =
      has_meshes(method) ? all.plan.meshes : std::vector<int>{0};
  for (const int mesh : meshes) {
    if (has_meshes(method) && mesh < smallest_mesh(method)) continue;
    PrecisionPoint point{mesh, run(method, mesh, all.plan.repetitions), {}, {}};
    if (point.run.solved()) {
      point.error = error_of(point.run, all.reference);
      if (method.kind != ComparedMethod::Kind::Extremal) {
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
    if (point.mesh > 0 && point.error) {
      errors.push_back({static_cast<double>(point.mesh), *point.error});
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
  const Run run = [&](const ComparedMethod& method, int mesh, int repetitions) {
    if (hooks.announce) {
      hooks.announce(mesh > 0 ? fmt::format("{}, {}", label(method), mesh)
                              : label(method));
    }
    return measure({subject.file, subject.overrides,
                    options_of(method, mesh, subject.problem.options),
                    repetitions, plan.seconds_per_point},
                   hooks.interrupt);
  };
  WorkPrecision out{subject, plan, find_reference(run), {}};
  for (const ComparedMethod& method : plan.methods) {
    out.lines.push_back(line_of(method, out, run));
    out.lines.back().order = order_of(out.lines.back(), out.floor());
  }
  return out;
}

}  // namespace brachisto::comparison
