// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/math/angle.hpp"
#include "brachisto/study/evaluate_path.hpp"
#include "study/option_errors.hpp"
#include "study/solve_run.hpp"

namespace brachisto {

namespace {

/// \throws std::invalid_argument  with all that is wrong, unless it is nothing
void refuse(std::string what, const std::vector<std::string>& errors) {
  if (errors.empty()) return;
  throw std::invalid_argument(
      fmt::format("{}:\n  {}", what, fmt::join(errors, "\n  ")));
}

std::vector<std::string> warnings_of(const Scene& scene) {
  const double theta_m = scene.body.theta_m;
  const double within = math::within_a_turn(theta_m);
  if (within == theta_m) return {};
  return {
      fmt::format("scene.body.theta_m: {} rad is more than a turn; whole "
                  "turns mean nothing, and {:.10g} rad is solved for",
                  theta_m, within)};
}

Solution solve_valid(const Scene& scene, const SolveOptions& options,
                     const SolveHooks& hooks) {
  if (scene.path) return evaluate_path(scene, options, hooks);
  if (hooks.neighbour != nullptr && follows_the_branch(options) &&
      can_continue(*hooks.neighbour, scene)) {
    Solution beside = SolveRun(scene, options, hooks).execute(hooks.neighbour);
    if (beside.verified()) return beside;
  }
  return SolveRun(scene, options, hooks).execute(nullptr);
}

}  // namespace

Solution solve(const Scene& scene, const SolveOptions& options,
               const SolveHooks& hooks) {
  std::vector<std::string> errors;
  for (const SceneError& error : validate(scene)) {
    errors.push_back(fmt::format("{}: {}", error.key, error.message));
  }
  refuse("the scene is not valid", errors);
  refuse("the options are not valid", option_errors(options));
  Solution solution = solve_valid(scene, options, hooks);
  solution.warnings = warnings_of(scene);
  return solution;
}

}  // namespace brachisto
