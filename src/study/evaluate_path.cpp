// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/evaluate_path.hpp"

#include <chrono>
#include <memory>
#include <stdexcept>

#include "brachisto/model/centre_curve.hpp"
#include "brachisto/trajectory/path_certificate.hpp"
#include "math/cpu_clock.hpp"
#include "study/within_limits.hpp"

namespace brachisto {

namespace {

void fill(Solution& out) {
  auto motion = std::make_shared<const PrescribedMotion>(
      without_whole_turns(out.scene), centre_curve(out.scene));
  if (motion->stall()) {
    out.status = Status::Stalled;
    out.message = motion->stall()->message();
    return;
  }
  out.status = Status::Solved;
  out.message = "the given path was evaluated, not optimised";
  out.estimated_error = motion->error_estimate();
  out.diagnostics = motion->diagnose();
  out.certificate = certify_path(
      *motion,
      out.options.discretisation.tolerance.value_or(kDefaultTolerance));
  out.on_given_path = std::move(motion);
}

}  // namespace

Solution evaluate_path(const Scene& scene, const SolveOptions& options,
                       const SolveHooks& hooks) {
  const auto start = StopCondition::Clock::now();
  const double start_cpu = process_cpu_seconds();
  Solution out;
  out.scene = scene;
  out.options = options;
  const StopCondition stop(options.limits.seconds, hooks.interrupt);
  within_limits(out, stop, [&] {
    try {
      fill(out);
    } catch (const std::invalid_argument& error) {
      out.status = Status::NoAdmissiblePath;
      out.message = error.what();
    }
  });
  out.effort.seconds =
      std::chrono::duration<double>(StopCondition::Clock::now() - start)
          .count();
  out.effort.cpu_seconds = process_cpu_seconds() - start_cpu;
  return out;
}

}  // namespace brachisto
