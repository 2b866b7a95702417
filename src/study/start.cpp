// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/contact.hpp"
#include "model/passage.hpp"
#include "model/scene_coordinate.hpp"
#include "model/world_part.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/world_continuation.hpp"
#include "study/shooting.hpp"
#include "study/wider_search.hpp"
#include "trajectory/trajectory.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {

namespace {

/// A longer scene, B off the uniform cylinder at its start by a quarter of r,
/// to continue without limits from:
///
///     (L − r)² + H² = (5/4 r)².
Scene with_cycloid(Scene scene) {
  const double r = scene.body.radius;
  scene.L = r + std::sqrt(1.5625 * r * r - scene.H * scene.H);
  return without_limits(std::move(scene));
}

/// Whether B lies in the body at its start, off-centred as it is: what tracks
/// there may be end in it, and none is known.
bool covers_finish(const Scene& scene) {
  const Point start = start_of_centre(in_ordinary_world(scene));
  return std::hypot(scene.L - start.x, scene.H - start.z) <= scene.body.radius;
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
      shoot(in_ordinary_world(posed.scene), posed.stop(), kEnoughToStartFrom);
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

/// From the cycloid of the scene, in the ordinary world.
Start start_in_offset(const PosedProblem& posed) {
  const CycloidArc& arc = *posed.cycloid;
  Start start = [&] {
    const PhaseTimer timer(Phase::Start);
    return Start{continue_from_cycloid(in_ordinary_world(posed.natural), arc,
                                       coarse_mesh(posed.natural, arc),
                                       posed.stop(), posed.progress()),
                 {}};
  }();
  if (!start.curve && !posed.stop().met()) follow_folds(posed, start);
  if (start.curve) return start;
  const std::string slow = slow_at_end(arc);
  // That search goes back from B in the ordinary world alone.
  const std::string search = posed.scene.world.ordinary()
                                 ? wider_search(posed.scene, posed.options)
                                 : std::string();
  if (!slow.empty()) {
    start.message += slow;
  } else if (!search.empty()) {
    start.message += ". Try " + search + ", which looks for other extremals";
  }
  return start;
}

/// Ends with `outcome`, and with the work done so far.
Start ended(Start start, Outcome outcome) {
  start.curve.reset();
  start.status = outcome.status;
  start.message = std::move(outcome.message);
  return start;
}

/// The branch of a scene that has a cycloid, followed back in L.
Start start_from_longer(const PosedProblem& posed) {
  constexpr double kSmallestStep = 1.0 / 1024.0;
  if (!posed.scene.body.off_centred() || covers_finish(posed.scene)) {
    return ended({}, without_cycloid(posed));
  }
  const PosedProblem longer =
      with_scene(posed, with_cycloid(in_ordinary_world(posed.scene)));
  Start start = start_from_cycloid(longer);
  if (posed.stop().met()) return start;
  const auto not_reached = [&](const std::string& how) {
    Outcome outcome = without_cycloid(posed);
    outcome.message += how;
    return outcome;
  };
  if (!start.curve) {
    return ended(std::move(start),
                 not_reached(fmt::format(". At L = {:.6g} m, where there is "
                                         "one, {}",
                                         longer.scene.L, start.message)));
  }
  const PhaseTimer timer(Phase::Start);
  const ExtremalCurve& curve = *start.curve;
  const RollingTime there(longer.natural, curve.mesh(), start.phi);
  Continuation back = continue_from_neighbour(
      in_ordinary_world(posed.natural),
      {longer.scene, curve.mesh(), prolong(curve, there), start.phi},
      posed.stop(), kSmallestStep);
  start.newton_steps += back.newton_steps;
  start.rejected_steps += back.rejected_steps;
  start.steps.insert(start.steps.end(), back.steps.begin() + 1,
                     back.steps.end());
  start.status = back.status;
  if (posed.stop().met()) return start;
  if (!back.curve) {
    const Scene last = between(longer.natural, posed.natural, back.reached);
    return ended(
        std::move(start),
        not_reached(fmt::format(
            ". The extremal of L = {:.6g} m was followed down to L = {:.6g} m",
            longer.scene.L, posed.scene.H * last.L / last.H)));
  }
  start.curve = std::move(back.curve);
  start.phi = back.phi;
  start.continued_from_L = longer.scene.L;
  return start;
}

/// Where the way through the offset and then into the world is blocked, the
/// other way round: the uniform body goes into the world first.
void follow_offset_in_world(const PosedProblem& posed, Start& start) {
  constexpr double kNextToNothing = 1e-12;
  Scene uniform = posed.natural;
  uniform.body.eta_m = kNextToNothing;
  const CycloidArc& arc = *posed.cycloid;
  Continuation way = continue_from_cycloid(in_ordinary_world(uniform), arc,
                                           coarse_mesh(posed.natural, arc),
                                           posed.stop(), posed.progress());
  if (way.curve) {
    way = continue_into_world(uniform, std::move(way), posed.stop(),
                              posed.progress());
  }
  if (way.curve) {
    way = continue_offset_in_world(posed.natural, std::move(way), posed.stop(),
                                   posed.progress());
  }
  start.newton_steps += way.newton_steps;
  start.rejected_steps += way.rejected_steps;
  if (!way.curve) return;
  way.newton_steps = start.newton_steps;
  way.rejected_steps = start.rejected_steps;
  start = {std::move(way), {}};  // no folds on this way
}

}  // namespace

Outcome without_cycloid(const PosedProblem& posed) {
  const Scene& scene = posed.scene;
  const bool proven =
      !scene.body.off_centred() && !posed.limited && scene.world.ordinary();
  return {proven ? Status::NoAdmissiblePath : Status::NotReached,
          fmt::format(
              "B lies inside the uniform cylinder at its start, (L − r)² + "
              "H² ≤ r² with r = {:g}, L = {:g}, H = {:g}: {}",
              scene.body.radius, scene.L, scene.H,
              proven ? "it has no smooth contact. Try a smaller radius or a "
                       "point B further away"
                     : "there is no cycloid to start from. That does not show "
                       "that this scene has no path. Try a smaller radius or a "
                       "point B further away")};
}

Start start_from_cycloid(const PosedProblem& posed) {
  Start start =
      posed.cycloid ? start_in_offset(posed) : start_from_longer(posed);
  if (!posed.natural.world.ordinary()) {
    const PhaseTimer timer(Phase::Start);
    if (start.curve) {
      if (posed.limited) {
        start.ordinary = start.curve;
        start.ordinary_phi = start.phi;
      }
      static_cast<Continuation&>(start) = continue_into_world(
          posed.natural, std::move(start), posed.stop(), posed.progress());
    }
    if (!start.curve && posed.cycloid && posed.natural.body.off_centred() &&
        !posed.stop().met()) {
      follow_offset_in_world(posed, start);
    }
  }
  if (start.curve) {
    start.ordinary.reset();
  } else if (posed.limited && !posed.stop().met()) {
    const Scene& scene = *posed.limited;
    if (!way_is_open(scene, inequalities(scene.body, scene.limits))) {
      start.ordinary.reset();
      return ended(std::move(start),
                   {Status::NoAdmissiblePath, std::string(kNoWay)});
    }
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
      !posed.options.follows_the_branch() ||
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
