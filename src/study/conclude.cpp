// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/conclude.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <ranges>
#include <utility>
#include <variant>

#include "model/loosened_limits.hpp"
#include "refinement/arc_elements.hpp"
#include "refinement/arcs_from_mesh.hpp"
#include "refinement/without_arcs.hpp"
#include "study/blocking_limit.hpp"
#include "study/certification.hpp"
#include "study/record.hpp"
#include "study/within_limits.hpp"

namespace brachisto {

void conclude(const PosedProblem& posed, MeshAnswer& found, Solution& out,
              std::optional<double> transit_time) {
  record(answer_of(posed, found, transit_time), out);
  {
    const CertificateTimer timer(out.effort);
    const auto& answer = std::get<CollocationAnswer>(*out.answer);
    record(certify(posed, found, answer.trajectory.curve()), out);
  }
  record(verdict(out, found.solution.message), out);
}

void conclude(const PosedProblem& posed, ArcLengthAnswer& found,
              const Start& start, Solution& out) {
  record(answer_of(posed, found), out);
  {
    const CertificateTimer timer(out.effort);
    const auto& motion = std::get<PiecewiseAnswer>(*out.answer).motion;
    record(certify(posed, found, motion, *start.curve, start.phi), out);
  }
  // Of a motion that stalls the certificate says so.
  if (!out.diagnostics) out.answer.reset();
  record(verdict(out, found.solution.message), out);
}

void record_limited(const PosedProblem& posed,
                    const LimitedRefinement& refinement, Solution& out) {
  record(refinement, out);
  if (!refinement.answer) {
    out.message += advice_without_answer(posed, refinement);
  }
}

void conclude(const PosedProblem& posed, const LimitedRefinement& refinement,
              Solution& out) {
  record_limited(posed, refinement, out);
  record_loosened(posed, refinement, out);
  if (!refinement.answer || posed.stop().met()) return;
  conclude(posed, *refinement.answer, refinement.message, out);
}

void record_loosened(const PosedProblem& posed,
                     const LimitedRefinement& refinement, Solution& out) {
  // A search may end beyond its share; what it found is looked at all the same.
  const double of_search = most_search_work(posed.mesh_options);
  const double most_work =
      std::max(of_search, refinement.work + kCertifyLooser * of_search);
  double work = refinement.work;
  for (const LoosenedPath& nearby : refinement.loosened | std::views::reverse) {
    for (const double more : {0.0, 0.001, 0.005, 0.02}) {  // for its digits
      if (out.relaxed || posed.stop().met() || work >= most_work) return;
      const double by = nearby.by + more;
      if (by == 0.0 || (more > 0.0 && !nearby.knows_arcs())) continue;
      const PosedProblem problem = with_scene(posed, loosened(posed.asked, by));
      Solution found = within_limits(problem, [&](Solution& there) {
        if (!nearby.knows_arcs()) {
          return conclude(problem, nearby, kSolvedWithoutArcs, there);
        }
        const auto beside = refine_limited_beside(
            *problem.limited, problem.program.discretisation, nearby.path,
            problem.mesh_options_after(there.effort), most_work - work);
        if (!beside) return;
        work += beside->work;
        conclude(problem, *beside, there);
      });
      out.effort += found.effort;
      if (found.verified()) {
        out.relaxed = std::make_shared<const Solution>(std::move(found));
      }
    }
  }
}

void conclude(const PosedProblem& posed, const LimitedAnswer& found,
              const std::string& message, Solution& out,
              std::optional<double> transit_time) {
  record(answer_of(posed, found, transit_time), out);
  {
    const CertificateTimer timer(out.effort);
    record(certify(posed, found), out);
  }
  record(verdict(out, message), out);
}

namespace {

/// Otherwise its effort alone.
void take_if_verified(Solution other, Solution& out) {
  if (other.verified()) {
    out = std::move(other);
  } else {
    out.effort = other.effort;
  }
}

/// From a path that fails its certificate, for the sign of a multiplier say, to
/// another one that its program leads to; nothing changes if that is not
/// verified.
void conclude_elsewhere(const PosedProblem& posed, const LimitedCurve& curve,
                        Solution& out) {
  Solution other = out;
  conclude(
      posed,
      refine_from_mesh({curve.problem().as_inequalities(), curve.point()},
                       posed.program.discretisation,
                       posed.mesh_options_after(out.effort), ItsArcs::Known),
      other);
  other.message += fmt::format(
      ". It takes the place of another path, which was not verified: {}",
      fmt::join(not_verified_because(out.certificate), "; "));
  take_if_verified(std::move(other), out);
}

/// Where nothing but the sign of a multiplier is wrong, on elements that are
/// short next to its junction; nothing changes if that is not verified.
void conclude_graded(const PosedProblem& posed, const FittedPath& path,
                     Solution& out) {
  const bool signs_alone =
      std::ranges::all_of(out.certificate.checks, [](const Check& check) {
        return check.passed || check.name == "multiplier_signs";
      });
  auto arcs = signs_alone ? graded_where_signs_err(path.curve, path.arcs)
                          : std::nullopt;
  if (!arcs) return;
  FittedPath graded = path;
  graded.arcs = *std::move(arcs);
  const auto finer =
      refine_limited_beside(*posed.limited, posed.program.discretisation,
                            graded, posed.mesh_options_after(out.effort));
  if (!finer) return;
  Solution other = out;
  conclude(posed, *finer, other);
  take_if_verified(std::move(other), out);
}

/// As conclude_resolved() does, which adds where the path came from.
void conclude_again_and_again(const PosedProblem& posed,
                              LimitedRefinement found, Solution& out,
                              Elsewhere elsewhere) {
  constexpr int kRounds = 3;
  const Discretisation& wanted = posed.program.discretisation;
  conclude(posed, found, out);
  for (int round = 1;; ++round) {
    if (!found.answer || found.answer->path.arcs.empty() || wanted.fixed() ||
        posed.stop().met() || out.certificate.verified()) {
      return;
    }
    const FittedPath path = found.answer->path;
    const auto resolved_by = [&](std::vector<Arc> arcs) {
      FittedPath other = path;
      other.arcs = std::move(arcs);
      auto finer = refine_limited_beside(*posed.limited, wanted, other,
                                         posed.mesh_options_after(out.effort));
      if (finer && !finer->answer) record_work(*finer, out);
      if (!finer || !finer->answer) return false;
      found = *std::move(finer);
      return true;
    };
    auto held = held_from_rest(path.curve, path.arcs);
    if (!held) held = turned_from_rest(path.curve, path.arcs);
    if (round == kRounds || (!(held && resolved_by(*std::move(held))) &&
                             !(under_resolved(out.certificate) &&
                               resolved_by(halved(path.arcs))))) {
      conclude_graded(posed, path, out);
      if (!out.verified() && elsewhere == Elsewhere::WithoutArcs) {
        conclude_elsewhere(posed, path.curve, out);
      }
      return;
    }
    conclude(posed, found, out);
  }
}

}  // namespace

void conclude_resolved(const PosedProblem& posed, LimitedRefinement found,
                       Solution& out, Elsewhere elsewhere) {
  const bool from_random = found.from_random;
  conclude_again_and_again(posed, std::move(found), out, elsewhere);
  if (from_random && out.verified()) {
    out.message +=
        ". The path was found from a random one; others may be faster";
  }
}

}  // namespace brachisto
