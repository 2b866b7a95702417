// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/world_part.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/world_continuation.hpp"
#include "study/shooting.hpp"
#include "study/wider_search.hpp"
#include "trajectory/trajectory.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto {

namespace {

std::string no_cycloid(const Scene& scene) {
  return fmt::format(
      "B lies inside the uniform cylinder at its start, (L − r)² + H² ≤ r² "
      "with r = {:g}, L = {:g}, H = {:g}, so that no branch starts from its "
      "path. Try a smaller radius or a point B further away",
      scene.body.radius, scene.L, scene.H);
}

/// Why B may lie too little below A; empty if it does not.
std::string slow_at_end(const CycloidArc& arc) {
  constexpr double kNextToRest = 1e-3;
  const double share = std::sin(0.5 * arc.psi_end);
  if (arc.psi_end < std::numbers::pi || share > kNextToRest) return {};
  return fmt::format(
      ". The uniform body arrives at B with {:.1e} of its greatest speed, and "
      "so close to rest digits are lost: try a larger H",
      std::max(0.0, share));
}

void follow_folds(const PosedProblem& posed, Start& start) {
  constexpr double kEnoughToStartFrom = 1e-10;
  const ExtremalSolution extremal =
      shoot(in_ordinary_world(posed.scene), kEnoughToStartFrom, posed.stop());
  start.newton_steps += extremal.newton_steps;
  if (!extremal.usable()) {
    start.message += ". By shooting: " + extremal.message;
    return;
  }
  start.folds = extremal.continuation.folds;
  start.phi = extremal.phi;
  const double length = extremal.centre_path_length / posed.units.length;
  const RollingTime problem(in_ordinary_world(posed.natural),
                            sampled_mesh(posed.natural.body, length),
                            extremal.phi);
  start.curve.emplace(problem, sample_extremal(extremal, posed.units, problem));
}

}  // namespace

Start start_from_cycloid(const PosedProblem& posed) {
  if (!posed.cycloid) {
    Start none;
    none.status = Status::NoAdmissiblePath;
    none.message = no_cycloid(posed.scene);
    return none;
  }
  const CycloidArc& arc = *posed.cycloid;
  Start start = [&] {
    const PhaseTimer timer(Phase::Start);
    return Start{continue_from_cycloid(in_ordinary_world(posed.natural), arc,
                                       coarse_mesh(posed.natural, arc),
                                       posed.stop(), posed.progress()),
                 {}};
  }();
  if (!start.curve && !posed.stop().met()) follow_folds(posed, start);
  if (start.curve && !posed.natural.world.ordinary()) {
    const PhaseTimer timer(Phase::Start);
    static_cast<Continuation&>(start) = continue_into_world(
        posed.natural, std::move(start), posed.stop(), posed.progress());
    return start;
  }
  if (start.curve) return start;
  const std::string slow = slow_at_end(arc);
  const std::string search = wider_search(posed.scene, posed.options);
  if (!slow.empty()) {
    start.message += slow;
  } else if (!search.empty()) {
    start.message += ". Try " + search + ", which looks for other extremals";
  }
  return start;
}

bool can_start_beside(const PosedProblem& posed, const Neighbour& neighbour) {
  return !posed.scene.path && !posed.limited && neighbour.arcs.empty() &&
         posed.options.follows_the_branch() &&
         can_continue(neighbour, posed.asked);
}

std::optional<FittedPath> path_beside(const PosedProblem& posed,
                                      const Neighbour& neighbour) {
  if (!posed.limited || neighbour.arcs.empty() ||
      posed.options.of<Collocation>() == nullptr ||
      neighbour.mesh.degree < kMinDegree ||
      neighbour.mesh.degree > kMaxDegree ||
      !validate(neighbour.scene).empty() ||
      !comparable(posed.asked, neighbour.scene)) {
    return std::nullopt;
  }
  return path_on_arcs(in_natural_units(neighbour.scene), neighbour.arcs,
                      neighbour.ends, neighbour.mesh.degree, neighbour.point);
}

Start start_beside(const PosedProblem& posed, const Neighbour& neighbour) {
  return {continue_from_neighbour(posed.natural, neighbour, posed.stop()), {}};
}

OtherStart start_elsewhere(const PosedProblem& posed, const Start& principal,
                           const Work& done) {
  const ExtremalCurve& known = *principal.curve;
  RollingTime problem(known.scene(), known.mesh(), principal.phi);
  const PrimalDual guess =
      posed.program.guess == Guess::Straight
          ? straight_guess(problem)
          : random_guess(problem, *posed.cycloid, posed.program.seed);
  // Lost in nowhere it must not use up what the answer needs.
  MeshOptions half = posed.mesh_options_after(done);
  half.ipopt.max_iterations /= 2;
  const MeshSolution found =
      solve_on_mesh(problem, {guess, principal.phi, -1.0}, half);
  OtherStart out{{}, {found.iterations, found.tangency.passes, 0, found.log}};
  out.cold.status = found.status;
  if (found.solved()) {
    const ExtremalCurve curve(problem, found.point);
    out.cold.tau = Trajectory(curve, posed.scene, posed.units).tau();
    // On the same mesh the same extremal has the same T, to the tolerance of
    // the continuation.
    out.cold.principal =
        std::abs(curve.transit_time() / known.transit_time() - 1.0) < 1e-6;
  }
  return out;
}

}  // namespace brachisto
