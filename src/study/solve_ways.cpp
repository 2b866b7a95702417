// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The ways to an answer.

#include "study/solve_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "brachisto/study/extremal_bridge.hpp"
#include "study/available_memory.hpp"
#include "study/certificate_timer.hpp"
#include "study/descent.hpp"
#include "study/fsolve_solution.hpp"
#include "study/other_start.hpp"
#include "study/shooting_answer.hpp"
#include "study/size_estimate.hpp"
#include "study/turn_meshes.hpp"
#include "study/wider_search.hpp"

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
std::string slow_arrival(const CycloidArc& arc) {
  constexpr double kNextToRest = 1e-3;
  const double share = std::sin(0.5 * arc.psi_end);
  if (arc.psi_end < std::numbers::pi || share > kNextToRest) return {};
  return fmt::format(
      ". The uniform body arrives at B with {:.1e} of its greatest speed, and "
      "so close to rest digits are lost: try a larger H",
      std::max(0.0, share));
}

}  // namespace

void SolveRun::try_other_start(const CycloidArc& arc,
                               const Continuation& principal) {
  // Lost in nowhere it must not use up what the answer needs.
  MeshOptions half = budget();
  half.ipopt.max_iterations /= 2;
  OtherStart other = start_elsewhere(scene_, options_, arc, principal, half);
  out_.effort.iterations += other.iterations;
  out_.effort.passes += other.passes;
  out_.log += other.log;
  out_.cold_start = other.cold;
}

/// A search starts from what is cheap to know: where the principal extremal is
/// a saddle, the minima beside it.
void SolveRun::add_minima_below(std::vector<ContactCandidate>& known) {
  Descent descent = descend(natural_, known.front(), budget());
  out_.effort.iterations += descent.iterations;
  out_.effort.passes += descent.passes;
  out_.log += descent.log;
  for (ContactCandidate& minimum : descent.minima) {
    known.push_back(std::move(minimum));
  }
}

void SolveRun::find_by_search(const CycloidArc& arc,
                              const Continuation& principal) {
  // As a multiple of the path of the uniform cylinder.
  constexpr double kLongest = 3.0;
  std::vector<ContactCandidate> known;
  if (principal.curve) known.push_back({*principal.curve, principal.phi});
  const bool has_principal = !known.empty();
  // Each of the extremals may take what the limit allows.
  const MeshOptions each = budget();
  if (has_principal) add_minima_below(known);
  const ContactSearch search = find_contacts(
      natural_, kLongest * arc.arc_length(arc.psi_end),
      [this](double length) { return sampled_mesh(natural_.body, length); },
      std::move(known), stop(), mesh_options_.progress);
  out_.search_remark = search.remark;
  out_.effort.newton_steps += search.newton_steps;
  JudgedBranches judged = judge_branches(scene_, options_.discretisation,
                                         search.contacts, has_principal, each);
  for (const JudgedBranch& one : judged.branches) {
    out_.branches.push_back(one.branch);
  }
  count(judged.meshes);
  if (JudgedBranch* best = best_branch(judged.branches)) {
    describe_way(best->refinement);
    report(*best->refinement.answer);
  } else {
    out_.status = judged.failure;
    out_.message = fmt::format(
        "of {} smooth contacts that the search found, none could be solved "
        "for as accurately as wanted",
        search.contacts.size());
  }
}

ExtremalSolution SolveRun::shoot(double tolerance) {
  ExtremalOptions options;
  options.follow_folds = true;
  options.tolerance = tolerance;
  options.stop = stop();
  ExtremalSolution extremal = solve_extremal(scene_, options);
  out_.effort.newton_steps += extremal.newton_steps;
  if (extremal.usable()) out_.folds = extremal.continuation.folds;
  return extremal;
}

/// Where the short continuation is stuck, pseudo-arclength continuation of the
/// indirect method goes on: through folds, and past near meetings of branches.
void SolveRun::follow_folds(Continuation& principal) {
  constexpr double kEnoughToStartFrom = 1e-10;
  const ExtremalSolution extremal = shoot(kEnoughToStartFrom);
  if (!extremal.usable()) {
    out_.message += ". By shooting: " + extremal.message;
    return;
  }
  const double length = extremal.centre_path_length / units_.length;
  const RollingTime problem(natural_, sampled_mesh(natural_.body, length),
                            extremal.phi);
  principal.curve.emplace(problem, sample_extremal(extremal, units_, problem));
  principal.phi = extremal.phi;
}

/// Method::Extremal: the numbers come from the indirect method; the collocation
/// problem on a fine mesh, which they must satisfy, is their certificate.
void SolveRun::find_by_shooting() {
  const ExtremalSolution extremal = shoot(ExtremalOptions{}.tolerance);
  if (!extremal.usable()) {
    out_.status = extremal.status == ExtremalStatus::NoCycloid
                      ? Status::NoAdmissiblePath
                      : Status::NotConverged;
    out_.message = extremal.message;
    return;
  }
  MeshAnswer answer = [&] {
    const CertificateTimer timer(out_.effort);
    return answer_from_extremal(natural_, units_, extremal, stop());
  }();
  out_.status = answer.solution.status;
  report(answer, extremal.transit_time);
}

/// Method::Fsolve: an answer to other equations, and its distance from this
/// one.
void SolveRun::find_by_fsolve() {
  out_.discrete = solve_discrete_system(scene_, options_, stop());
  out_.status = out_.discrete->status;
  out_.message = out_.discrete->message;
  out_.effort.iterations = out_.discrete->iterations;
  if (!out_.discrete->solved()) return;
  const CertificateTimer timer(out_.effort);
  const ExtremalSolution extremal = shoot(ExtremalOptions{}.tolerance);
  out_.extremal = opinion_on(*out_.discrete, extremal);
  out_.certificate = certify_discrete(*out_.discrete, *out_.extremal);
  out_.message = fmt::format(
      "the discrete equations hold, but: {}",
      fmt::join(brachisto::not_verified_because(out_.certificate), "; "));
}

/// Whether the scene is small enough for the memory and the time that there is;
/// says so if not.
bool SolveRun::fits(const CycloidArc& arc) {
  const double number = turns(natural_.body, arc.arc_length(arc.psi_end));
  const std::optional<TooLarge> too_large =
      brachisto::too_large(estimate_size(number, options_), available_memory(),
                           options_.limits.seconds);
  if (!too_large) return true;
  out_.status = too_large->status;
  out_.message = too_large->message;
  return false;
}

void SolveRun::find() {
  const std::optional<CycloidArc> arc = axisymmetric_optimum(natural_);
  if (arc && !fits(*arc)) return;
  if (options_.method == Method::Extremal) return find_by_shooting();
  if (options_.method == Method::Fsolve) return find_by_fsolve();
  if (!arc) {
    out_.status = Status::NoAdmissiblePath;
    out_.message = no_cycloid(scene_);
    return;
  }
  Continuation principal = [&] {
    const PhaseTimer timer(Phase::Start);
    return continue_from_cycloid(natural_, *arc, coarse_mesh(natural_, *arc),
                                 stop(), mesh_options_.progress);
  }();
  out_.effort.newton_steps += principal.newton_steps;
  out_.effort.continuation = principal.steps;
  out_.status = principal.status;
  out_.message = principal.message;
  if (!principal.curve && !stop().met()) follow_folds(principal);
  if (stop().met()) return;
  if (options_.search == Search::Global &&
      natural_.contact == Contact::Smooth) {
    return find_by_search(*arc, principal);
  }
  if (!principal.curve) {
    const std::string slow = slow_arrival(*arc);
    const std::string search = wider_search(scene_.contact, options_);
    if (!slow.empty()) {
      out_.message += slow;
    } else if (!search.empty()) {
      out_.message += ". Try " + search + ", which looks for other extremals";
    }
    return;
  }
  if (options_.guess != Guess::Cycloid) try_other_start(*arc, principal);
  answer_from(principal);
}

void SolveRun::find_beside(const Neighbour& neighbour) {
  const Continuation found =
      continue_from_neighbour(natural_, neighbour, stop());
  out_.effort.newton_steps += found.newton_steps;
  out_.effort.continuation = found.steps;
  out_.status = found.status;
  out_.message = found.message;
  if (found.curve) answer_from(found);
}

/// The same by straight pieces, in the paper's variables.
void SolveRun::answer_on_pieces(const Continuation& start) {
  ArcLengthRefinement refinement = refine_arc_length(
      natural_, options_.discretisation, *start.curve, start.phi, budget());
  book(refinement);
  if (refinement.answer && !stop().met()) report(*refinement.answer, start);
}

/// Refines until T is as accurate as wanted and, where the path bends sharply,
/// until it is resolved between the nodes too.
void SolveRun::answer_from(const Continuation& start) {
  if (options_.discretisation.formulation == Formulation::ArcLength) {
    return answer_on_pieces(start);
  }
  constexpr int kRounds = 3;
  constexpr double kTighter = 1e-2;
  Discretisation wanted = options_.discretisation;
  ExtremalCurve curve = *start.curve;
  double phi = start.phi;
  for (int round = 0; round < kRounds; ++round) {
    Refinement refinement = refine(natural_, wanted, curve, phi, budget());
    book(refinement);
    if (!refinement.answer || stop().met()) return;
    // A better answer than the best one was still wanted.
    if (refinement.status == Status::IterationLimit) return;
    report(*refinement.answer);
    if (wanted.fixed() || !under_resolved(out_.certificate)) return;
    curve = refinement.answer->curve();
    phi = refinement.answer->solution.closure.phi;
    wanted.tolerance = kTighter * wanted.tolerance.value_or(kDefaultTolerance);
  }
}

}  // namespace brachisto
