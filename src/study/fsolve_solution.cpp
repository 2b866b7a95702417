// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "study/fsolve_solution.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "brachisto/transcription/discretisation.hpp"

namespace brachisto {

FsolveAnswer solve_discrete_system(const Scene& scene,
                                   const SolveOptions& options,
                                   const StopCondition& stop) {
  return fsolve_answer(scene,
                       options.discretisation.nodes.value_or(kDiscreteNodes),
                       options.fsolve, options.limits.iterations, stop);
}

ExtremalOpinion opinion_on(const FsolveAnswer& answer,
                           const ExtremalSolution& extremal) {
  ExtremalOpinion opinion;
  opinion.solved = extremal.usable();
  opinion.message = extremal.message;
  if (opinion.solved) {
    opinion.tau = extremal.tau;
    opinion.error_estimate = extremal.error_estimate;
    opinion.difference = std::abs(answer.tau / extremal.tau - 1.0);
  }
  return opinion;
}

Certificate certify_discrete(const FsolveAnswer& answer,
                             const ExtremalOpinion& opinion) {
  Certificate certificate;
  certificate.add("discrete_residual", answer.residual,
                  FsolveOptions{}.tolerance);
  certificate.add(
      "discretisation",
      opinion.solved ? opinion.difference
                     : std::numeric_limits<double>::quiet_NaN(),
      kDefaultTolerance,
      opinion.solved
          ? fmt::format("τ = {:.6f} of {} nodes, {:.6f} of the extremal",
                        answer.tau, answer.nodes, opinion.tau)
          : opinion.message);
  return certificate;
}

}  // namespace brachisto
