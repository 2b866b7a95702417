// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "reproduction/transit.hpp"

#include <fmt/format.h>

namespace brachisto::reproduction {

void check(const Interrupt& interrupt) {
  if (interrupt.load() != 0) throw Interrupted();
}

Solution verified_solution(const Scene& scene, const Interrupt& interrupt) {
  SolveOptions options;
  options.discretisation.tolerance = 1e-12;
  Solution solution = solve(scene, options, {.interrupt = &interrupt});
  check(interrupt);
  if (!solution.verified()) {
    throw NotVerified(fmt::format(
        "η_m = {:.6g}, θ_m = {:.6g} rad, k = {:.6g}: no verified answer: {}",
        scene.body.eta_m, scene.body.theta_m, scene.body.k, solution.message));
  }
  return solution;
}

double verified_tau(const Scene& scene, const Interrupt& interrupt) {
  return verified_solution(scene, interrupt).motion()->tau();
}

}  // namespace brachisto::reproduction
