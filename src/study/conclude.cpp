// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/conclude.hpp"

#include <memory>
#include <ranges>
#include <utility>
#include <variant>

#include "model/loosened_limits.hpp"
#include "refinement/arc_elements.hpp"
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
  if (refinement.blocking) {
    out.message += in_words(posed, *refinement.blocking);
  } else if (!refinement.answer && (out.status == Status::NotConverged ||
                                    out.status == Status::NoAdmissiblePath)) {
    const std::string looser = looser_limits(posed.asked);
    if (!looser.empty()) out.message += ". To try: " + looser;
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
  // Where limits can hardly be kept a path may be found and its digits not.
  constexpr int kMostPaths = 6;
  for (const LoosenedPath& nearby : refinement.loosened | std::views::reverse |
                                        std::views::take(kMostPaths)) {
    for (const double more : {0.0, 0.001, 0.005, 0.02}) {
      if (posed.stop().met()) return;
      const double by = nearby.by + more;
      if (by == 0.0) continue;  // not verified as asked
      const PosedProblem problem = with_scene(posed, loosened(posed.asked, by));
      auto solution = std::make_shared<const Solution>(
          within_limits(problem, [&](Solution& tried) {
            const auto beside = refine_limited_beside(
                *problem.limited, problem.program.discretisation, nearby.path,
                problem.mesh_options_after(tried.effort));
            if (beside) conclude(problem, *beside, tried);
          }));
      out.effort += solution->effort;
      if (!solution->verified()) continue;
      out.relaxed = std::move(solution);
      return;
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

void conclude_resolved(const PosedProblem& posed, LimitedRefinement found,
                       Solution& out) {
  constexpr int kRounds = 3;
  const Discretisation& wanted = posed.program.discretisation;
  conclude(posed, found, out);
  for (int round = 1; round < kRounds; ++round) {
    if (!found.answer || found.answer->path.arcs.empty() || wanted.fixed() ||
        posed.stop().met() || !under_resolved(out.certificate)) {
      return;
    }
    FittedPath path = found.answer->path;
    path.arcs = halved(std::move(path.arcs));
    auto finer = refine_limited_beside(*posed.limited, wanted, path,
                                       posed.mesh_options_after(out.effort));
    if (finer && !finer->answer) record_work(*finer, out);
    if (!finer || !finer->answer) return;
    found = *std::move(finer);
    conclude(posed, found, out);
  }
}

}  // namespace brachisto
