// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Small problems, solved.

#pragma once

#include <stdexcept>
#include <utility>

#include "brachisto/solvers/program_solvers.hpp"
#include "model/cycloid.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto::testing {

/// A problem and its solution, to Ipopt's tolerance of 1e-12 on the residuals.
struct SolvedProblem {
  RollingTime problem;
  PrimalDual point;
};

/// Solves from the cycloid between the end points of the centre.
///
/// \throws std::runtime_error if Ipopt does not solve it
[[nodiscard]] inline SolvedProblem solved(const Scene& scene, Mesh mesh,
                                          double phi) {
  RollingTime problem(scene, std::move(mesh), phi);
  const auto arc =
      cycloid_between(start_of_centre(scene), end_of_centre(scene, phi));
  if (!arc) throw std::runtime_error("no cycloid between the end points");
  SolverResult result =
      solve_with_ipopt(problem, cycloid_guess(problem, *arc), {});
  if (result.status != Status::Solved) {
    throw std::runtime_error(result.message);
  }
  return {std::move(problem), std::move(result.point)};
}

}  // namespace brachisto::testing
