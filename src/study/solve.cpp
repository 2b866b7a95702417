// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "brachisto/study/evaluate_path.hpp"
#include "study/solve_run.hpp"

namespace brachisto {

namespace {

/// \throws std::invalid_argument if arc_length is combined with what it has not
void check_formulation(const SolveOptions& options) {
  const Discretisation& mesh = options.discretisation;
  if (mesh.formulation != Formulation::ArcLength) return;
  const int pieces = mesh.elements ? *mesh.elements
                     : mesh.nodes  ? *mesh.nodes - 1
                                   : kFewestPieces;
  if (mesh.degree || pieces < kFewestPieces ||
      !solves_the_program(options.method) ||
      options.search != Search::Principal || options.guess != Guess::Cycloid ||
      mesh.wanted_tolerance() < kSmallestArcLengthTolerance) {
    throw std::invalid_argument(fmt::format(
        "the formulation arc_length has no degree, {} pieces or more, the "
        "method ipopt or newton_kkt, the search principal, the guess cycloid, "
        "and a "
        "tolerance of {:g} or more",
        kFewestPieces, kSmallestArcLengthTolerance));
  }
}

}  // namespace

Solution solve(const Scene& scene, const SolveOptions& options,
               const SolveHooks& hooks) {
  const std::vector<SceneError> errors = validate(scene);
  if (!errors.empty()) {
    std::string text = "the scene is not valid:";
    for (const SceneError& error : errors) {
      text += fmt::format("\n  {}: {}", error.key, error.message);
    }
    throw std::invalid_argument(text);
  }
  if (scene.path) return evaluate_path(scene, options);
  check_formulation(options);
  if (hooks.neighbour != nullptr && comparable(scene, hooks.neighbour->scene) &&
      follows_the_branch(options)) {
    Solution beside = SolveRun(scene, options, hooks).execute(hooks.neighbour);
    if (beside.verified()) return beside;
  }
  return SolveRun(scene, options, hooks).execute(nullptr);
}

}  // namespace brachisto
