// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The way of a scene: pose → start → refine → answer → certify → verdict. A
// stage is a function from values to a value. What it returns is recorded in
// the solution at once, so that a solve that is stopped between two stages
// still tells how far it came: here up to the refinement, and from it on, where
// answers are put down, by conclude().

#include "brachisto/study/solve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "refinement/turn_meshes.hpp"
#include "search/descent.hpp"
#include "search/limited_search.hpp"
#include "study/answer.hpp"
#include "study/certification.hpp"
#include "study/conclude.hpp"
#include "study/limited_branches.hpp"
#include "study/limited_shooting.hpp"
#include "study/record.hpp"
#include "study/resolve.hpp"
#include "study/shooting.hpp"
#include "study/size.hpp"
#include "study/solve_beside.hpp"
#include "study/start.hpp"
#include "study/within_limits.hpp"

namespace brachisto {

namespace {

Solution beside(const PosedProblem& posed, const Neighbour& neighbour);
void solve_posed(const PosedProblem& posed, Solution& out);
void follow_neighbour(const PosedProblem& posed, const Neighbour& neighbour,
                      Solution& out);
void differentiate(const PosedProblem& posed, Solution& out);
void solve_program(const PosedProblem& posed, const Start& start,
                   Solution& out);
void solve_by_shooting(const PosedProblem& posed, Solution& out);
void shoot_under_limits(const PosedProblem& posed, Solution& out);
void solve_by_discrete_system(const PosedProblem& posed,
                              const DiscreteSystem& system, Solution& out);
void follow_given_path(const PosedProblem& posed, Solution& out);
void search_contacts(const PosedProblem& posed, const Start& principal,
                     Solution& out);
void search_under_limits(const PosedProblem& posed, const Start& principal,
                         Solution& out);
void seek_other_paths(const PosedProblem& posed, const Start& principal,
                      Solution& out);
void refine_elements(const PosedProblem& posed, const Start& start,
                     Solution& out);
void refine_pieces(const PosedProblem& posed, const Start& start,
                   Solution& out);
void refine_under_limits(const PosedProblem& posed, const Start& start,
                         Solution& out);
void refine_cold_under_limits(const PosedProblem& posed, const Start& start,
                              Solution& out);
void with_the_care_it_takes(
    const PosedProblem& posed, Solution& out,
    const std::function<bool(Tightening::Care, Solution&)>& way);

}  // namespace

Solution solve_beside(const Scene& scene, const SolveOptions& options,
                      const SolveHooks& hooks) {
  return beside(pose(scene, options, hooks), *hooks.neighbour);
}

Solution solve(const Scene& scene, const SolveOptions& options,
               const SolveHooks& hooks) {
  const PosedProblem posed = pose(scene, options, hooks);
  if (hooks.neighbour != nullptr) {
    Solution found = beside(posed, *hooks.neighbour);
    if (found.verified()) return found;
  }
  return within_limits(posed, [&](Solution& out) {
    solve_posed(posed, out);
    differentiate(posed, out);
  });
}

namespace {

Solution beside(const PosedProblem& posed, const Neighbour& neighbour) {
  return within_limits(posed, [&](Solution& out) {
    follow_neighbour(posed, neighbour, out);
    differentiate(posed, out);
  });
}

void solve_posed(const PosedProblem& posed, Solution& out) {
  if (posed.scene.path) return follow_given_path(posed, out);
  if (posed.cycloid) {
    if (auto outcome =
            too_large(forecast(posed), posed.options.limits.seconds)) {
      return record(*std::move(outcome), out);
    }
  }
  const SolveOptions& options = posed.options;
  if (options.of<Shooting>() != nullptr) return solve_by_shooting(posed, out);
  if (const auto* system = options.of<DiscreteSystem>()) {
    return solve_by_discrete_system(posed, *system, out);
  }
  solve_program(posed, start_from_cycloid(posed), out);
}

/// From a neighbour, if it is one.
void follow_neighbour(const PosedProblem& posed, const Neighbour& neighbour,
                      Solution& out) {
  if (can_start_beside(posed, neighbour)) {
    return solve_program(posed, start_beside(posed, neighbour), out);
  }
  const auto path = path_beside(posed, neighbour);
  if (!path) return;
  auto refinement =
      refine_limited_beside(*posed.limited, posed.program.discretisation, *path,
                            posed.mesh_options_after(out.effort));
  if (refinement) {
    conclude_resolved(posed, *std::move(refinement), out, Elsewhere::Nowhere);
  }
}

/// What the time changes by with the scene.
void differentiate(const PosedProblem& posed, Solution& out) {
  const auto* program = posed.options.of<Collocation>();
  if (program == nullptr || !out.verified() ||
      program->sensitivities == SensitivityOrder::None) {
    return;
  }
  const PhaseTimer timer(Phase::Diagnosis);
  out.sensitivities =
      sensitivities(out, program->sensitivities == SensitivityOrder::Second);
}

// ---- The ways, one for each kind of answer.

/// The nonlinear program.
void solve_program(const PosedProblem& posed, const Start& start,
                   Solution& out) {
  record(start, out);
  if (posed.stop().met()) return;
  // What a search looks through is measured by some path.
  if (posed.options.searches() && (posed.cycloid || start.curve)) {
    return posed.limited ? search_under_limits(posed, start, out)
                         : search_contacts(posed, start, out);
  }
  if (!start.curve) return refine_cold_under_limits(posed, start, out);
  if (posed.limited) return refine_under_limits(posed, start, out);
  if (posed.program.guess != Guess::Cycloid && posed.cycloid) {
    record(start_elsewhere(posed, start, out.effort), out);
  }
  if (posed.program.discretisation.formulation == Formulation::ArcLength) {
    return refine_pieces(posed, start, out);
  }
  refine_elements(posed, start, out);
}

/// Shooting: the numbers come from the indirect method; the collocation
/// problem on a fine mesh, which they must satisfy, is their certificate.
void solve_by_shooting(const PosedProblem& posed, Solution& out) {
  if (posed.limited) return shoot_under_limits(posed, out);
  const ExtremalSolution extremal = shoot(posed.scene, posed.stop());
  record(extremal, out);
  if (extremal.status == ExtremalStatus::NoCycloid) {
    Outcome outcome = without_cycloid(posed);
    if (outcome.status == Status::NotReached) {
      outcome.message += ". Try method: ipopt, which can start at a greater L";
    }
    return record(std::move(outcome), out);
  }
  record(outcome_of(extremal), out);
  if (!extremal.usable()) return;
  MeshAnswer found = [&] {
    const CertificateTimer timer(out.effort);
    return answer_from_extremal(posed, extremal);
  }();
  conclude(posed, found, out, extremal.transit_time);
}

/// The same under limits. Which arcs there are the program finds, as accurately
/// as that takes.
void shoot_under_limits(const PosedProblem& posed, Solution& out) {
  constexpr double kForArcs = 1e-6;
  const Start start = start_from_cycloid(posed);
  record(start, out);
  if (posed.stop().met() || !start.curve) return;
  Discretisation loose = posed.program.discretisation;
  loose.tolerance = std::max(kForArcs, loose.wanted_tolerance());
  const auto shot = [&](Tightening::Care care, Solution& there) {
    const LimitedRefinement program =
        refine_limited(*posed.limited, loose, *start.curve, start.phi,
                       posed.mesh_options_after(there.effort), care);
    record_limited(posed, program, there);
    record_loosened(posed, program, there);
    if (!program.answer || posed.stop().met()) return program.rough;
    const FittedPath& nearby = program.answer->path;
    const LimitedExtremal extremal = shoot_over_arcs(nearby, posed.stop());
    record(extremal, there);
    const Outcome outcome = outcome_of(extremal);
    record(outcome, there);
    if (outcome.status != Status::Solved) return program.rough;
    const LimitedAnswer found = [&] {
      const CertificateTimer timer(there.effort);
      return answer_from_extremal(nearby, extremal, posed.stop());
    }();
    conclude(posed, found, outcome.message, there,
             extremal.transit_time * posed.units.time);
    return program.rough;
  };
  with_the_care_it_takes(posed, out, shot);
}

/// The paper's discrete system: an answer to other equations, and its distance
/// from this one.
void solve_by_discrete_system(const PosedProblem& posed,
                              const DiscreteSystem& system, Solution& out) {
  const DiscreteAnswer found = solve_discrete_system(
      posed.scene, system, posed.options.limits.iterations, posed.stop());
  out.effort.iterations = found.iterations;
  out.answer = std::make_shared<const Answer>(found);
  record(Outcome{found.status, found.message}, out);
  if (!found.solved()) return;
  const CertificateTimer timer(out.effort);
  const ExtremalSolution extremal = shoot(posed.scene, posed.stop());
  record(extremal, out);
  const CrossCheck check = compare_with(extremal, found.tau / extremal.tau);
  record(Certified{certify_discrete(found, check), check}, out);
  out.message = fmt::format("the discrete equations hold, but: {}",
                            fmt::join(out.not_verified_because(), "; "));
}

/// The path that the scene states, evaluated.
void follow_given_path(const PosedProblem& posed, Solution& out) {
  try {
    Answered answered = answer_on_given_path(posed);
    const auto& motion = std::get<PrescribedMotion>(*answered.answer);
    if (motion.stall()) {
      return record(Outcome{Status::Stalled, motion.stall()->message()}, out);
    }
    {
      const CertificateTimer timer(out.effort);
      record(certify_given_path(posed, motion), out);
    }
    record(std::move(answered), out);
    record(
        Outcome{Status::Solved, "the given path was evaluated, not optimised"},
        out);
  } catch (const std::invalid_argument& error) {
    record(Outcome{Status::NoAdmissiblePath, error.what()}, out);
  }
}

// ---- From a start to an answer.

/// All extremals of the free motion that a search finds, those that are known
/// from the start first: what is cheap to know, the principal one, and where it
/// is a saddle, the minima beside it. In other worlds none are looked for.
ContactSearch free_contacts(const PosedProblem& posed, const Start& principal,
                            const MeshOptions& each, Solution& out) {
  // As a multiple of the path of the uniform cylinder, or what is in its place.
  constexpr double kLongest = 3.0;
  const double uniform = posed.cycloid
                             ? posed.cycloid->arc_length(posed.cycloid->psi_end)
                             : principal.curve->arc_length();
  std::vector<ContactCandidate> known;
  if (principal.curve) {
    known.push_back({*principal.curve, principal.phi});
    Descent descent = descend(posed.natural, known.front(), each);
    out.effort += descent.work;
    std::move(descent.minima.begin(), descent.minima.end(),
              std::back_inserter(known));
  }
  ContactSearch search;
  if (posed.natural.world.ordinary()) {
    search = find_contacts(
        posed.natural, kLongest * uniform,
        [&](double length) { return sampled_mesh(posed.natural.body, length); },
        std::move(known), posed.stop(), posed.progress());
  } else {
    search.remark = known.empty()
                        ? "no extremal without limits is known"
                        : "in this world extremals without limits are looked "
                          "for beside the principal one alone";
    search.contacts = std::move(known);
  }
  record(search, out);
  return search;
}

/// The fastest of all extremals that can be found is the answer.
void search_contacts(const PosedProblem& posed, const Start& principal,
                     Solution& out) {
  // Each of the extremals may take what the limit allows.
  const MeshOptions each = posed.mesh_options_after(out.effort);
  const ContactSearch search = free_contacts(posed, principal, each, out);
  JudgedBranches judged =
      judge_branches(posed, posed.program.discretisation, search.contacts,
                     principal.curve && !principal.continued_from_L, each);
  record(judged, out);
  if (posed.stop().met()) return;
  JudgedBranch* best = best_branch(judged.branches);
  if (best == nullptr) {
    return record(
        Outcome{
            judged.failure,
            fmt::format("of {} extremals that the search found, none could be "
                        "solved for as accurately as wanted",
                        search.contacts.size())},
        out);
  }
  record_way(best->refinement, out);
  conclude(posed, *best->refinement.answer, out);
}

/// Under limits: the answer without a search, which is the principal one, and
/// others from many starts; the fastest is the answer. Where the first one
/// stands its own outcome is told. A proof that there is none ends the search,
/// and where time does, what is verified by then is the answer.
void search_under_limits(const PosedProblem& posed, const Start& principal,
                         Solution& out) {
  if (principal.curve) {
    refine_under_limits(posed, principal, out);
  } else {
    refine_cold_under_limits(posed, principal, out);
  }
  if (out.status == Status::NoFastestTrack ||
      out.status == Status::NoAdmissiblePath) {
    return;
  }
  try {
    seek_other_paths(posed, principal, out);
    if (!posed.stop().met()) return;
  } catch (const Stopped&) {
    if (!posed.stop().met()) throw;
  }
  if (posed.stop().interrupted() || !out.verified()) return;
  record_cut(posed.options.limits.seconds, out);
  throw AnswerStands();
}

void seek_other_paths(const PosedProblem& posed, const Start& principal,
                      Solution& out) {
  if (posed.stop().met()) return;
  const MeshOptions each = posed.mesh_options_after({});
  const ContactSearch free = free_contacts(posed, principal, each, out);
  LimitedSearch search;
  if (!free.contacts.empty()) {
    search = find_limited_paths(*posed.limited, free.contacts, each);
  }
  record(search, out);
  judge_limited_paths(posed, search.paths, out);
}

/// By collocation.
void refine_elements(const PosedProblem& posed, const Start& start,
                     Solution& out) {
  refine_until_resolved(
      posed.natural, posed.program.discretisation, {*start.curve, start.phi},
      [&] { return posed.mesh_options_after(out.effort); },
      [&](Refinement found) -> const Certificate* {
        record(found, out);
        // At the limit a better answer than the best one was still wanted.
        if (!found.answer || posed.stop().met() ||
            found.status == Status::IterationLimit) {
          return nullptr;
        }
        conclude(posed, *found.answer, out);
        return &out.certificate;
      });
}

/// The same by straight pieces, in the paper's variables.
void refine_pieces(const PosedProblem& posed, const Start& start,
                   Solution& out) {
  ArcLengthRefinement refinement = refine_arc_length(
      posed.natural, posed.program.discretisation, *start.curve, start.phi,
      posed.mesh_options_after(out.effort));
  record(refinement, out);
  if (!refinement.answer || posed.stop().met()) return;
  conclude(posed, *refinement.answer, start, out);
}

/// Where the free extremal was not reached in this world.
void refine_cold_under_limits(const PosedProblem& posed, const Start& start,
                              Solution& out) {
  if (!start.ordinary) return;
  const LimitedRefinement found = refine_limited_cold(
      *posed.limited, posed.program.discretisation, *start.ordinary,
      start.ordinary_phi, posed.mesh_options_after(out.effort));
  if (found.answer) return conclude_resolved(posed, found, out);
  record_work(found, out);
  if (!found.tried.empty()) {
    out.message += ". From random paths none was found under the limits either";
  }
}

/// Roughly, and if what that leads to is not verified once more with care, with
/// nothing of the first but what it took.
///
/// \param way  whether its outcome rests on a rough path
void with_the_care_it_takes(
    const PosedProblem& posed, Solution& out,
    const std::function<bool(Tightening::Care, Solution&)>& way) {
  const Solution before = out;
  const bool rough = way(Tightening::Care::Rough, out);
  // A mesh that is fixed may only be too coarse.
  if (!rough || out.verified() || posed.program.discretisation.fixed() ||
      posed.stop().met()) {
    return;
  }
  Solution with_care = before;
  with_care.effort = out.effort;
  way(Tightening::Care::Full, with_care);
  out = std::move(with_care);
}

void refine_under_limits(const PosedProblem& posed, const Start& start,
                         Solution& out) {
  with_the_care_it_takes(
      posed, out, [&](Tightening::Care care, Solution& there) {
        const LimitedRefinement found = refine_limited(
            *posed.limited, posed.program.discretisation, *start.curve,
            start.phi, posed.mesh_options_after(there.effort), care);
        conclude_resolved(
            posed, found, there,
            found.rough ? Elsewhere::Nowhere : Elsewhere::WithoutArcs);
        return found.rough;
      });
}

}  // namespace
}  // namespace brachisto
