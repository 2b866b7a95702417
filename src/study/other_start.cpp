// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/other_start.hpp"

#include <cmath>

#include "brachisto/model/units.hpp"
#include "brachisto/trajectory/trajectory.hpp"
#include "brachisto/transcription/initial_guess.hpp"

namespace brachisto {

OtherStart start_elsewhere(const Scene& scene, const SolveOptions& options,
                           const CycloidArc& arc, const Continuation& principal,
                           const MeshOptions& budget) {
  const ExtremalCurve& known = *principal.curve;
  RollingTime problem(known.scene(), known.mesh(), principal.phi);
  const PrimalDual guess = options.guess == Guess::Straight
                               ? straight_guess(problem)
                               : random_guess(problem, arc, options.seed);
  const MeshSolution found =
      solve_on_mesh(problem, {guess, principal.phi, -1.0}, budget);
  OtherStart out{{}, found.iterations, found.closure.passes, found.log};
  out.cold.status = found.status;
  if (found.solved()) {
    const ExtremalCurve curve(problem, found.point);
    out.cold.tau = Trajectory(curve, scene, natural_units(scene)).tau();
    // On the same mesh the same extremal has the same T, to the tolerance of
    // the continuation.
    out.cold.principal =
        std::abs(curve.transit_time() / known.transit_time() - 1.0) < 1e-6;
  }
  return out;
}

}  // namespace brachisto
