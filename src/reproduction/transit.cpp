// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/transit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brachisto::reproduction {

void check(const Interrupt& interrupt) {
  if (interrupt.load() != 0) throw Interrupted();
}

Solution verified_solution(const Scene& scene, const Interrupt& interrupt,
                           double tolerance) {
  SolveOptions options;
  options.discretisation.tolerance = tolerance;
  Solution solution = solve(scene, options, {.interrupt = &interrupt});
  check(interrupt);
  if (!solution.verified()) {
    const std::vector<std::string> checks = solution.not_verified_because();
    throw NotVerified(fmt::format(
        "η_m = {:.6g}, θ_m = {:.6g} rad, k = {:.6g}: no verified answer: {}",
        scene.body.eta_m, scene.body.theta_m, scene.body.k,
        checks.empty() ? solution.message
                       : fmt::format("{}", fmt::join(checks, "; "))));
  }
  return solution;
}

double verified_tau(const Scene& scene, const Interrupt& interrupt) {
  return verified_solution(scene, interrupt).motion()->tau();
}

}  // namespace brachisto::reproduction
