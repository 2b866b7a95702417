// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Starts of arc_length problems: what a rolling_time solution, or one with
// fewer pieces, is worth on a mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/inertia.hpp"
#include "support/observed_order.hpp"
#include "support/rounding.hpp"
#include "support/scenes.hpp"
#include "support/solved_problem.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto::testing {
namespace {

constexpr double kPhi = -0.15;

/// Solution of `problem`, started from an extremal.
PrimalDual solve_arc(ArcLength& problem) {
  const SolvedProblem smooth =
      solved(problem.scene(), uniform_mesh(5, 16), kPhi);
  const ExtremalCurve curve(smooth.problem, smooth.point);
  SolverResult result = solve_with_ipopt(problem, prolong(curve, problem), {});
  if (result.status != Status::Solved) throw std::runtime_error(result.message);
  return std::move(result.point);
}

class ArcStartOf : public ::testing::TestWithParam<Scene> {};
INSTANTIATE_TEST_SUITE_P(Bodies, ArcStartOf,
                         ::testing::Values(natural(bead_scene()),
                                           natural(uniform_scene()),
                                           natural(off_centred_scene(-0.5))));

TEST_P(ArcStartOf, MultipliersOfTheCostatesAreThoseOfTheSolver) {
  // Both solve the stationarity conditions, to 1e-12 and exactly; the sums that
  // carry the momentum from the end to the start have 60 terms.
  constexpr double kDifference = 60 * 1e-12;
  ArcLength problem(GetParam(), 60, kPhi);
  const PrimalDual solution = solve_arc(problem);
  ASSERT_TRUE(problem.set_point(solution.x));
  const Costates p = problem.end_costates(solution.lambda);

  const std::vector<double> lambda = problem.multipliers(p.p_x, p.p_z);

  const double largest = std::abs(*std::ranges::max_element(
      solution.lambda, {}, [](double l) { return std::abs(l); }));
  for (std::size_t i = 0; i < lambda.size(); ++i) {
    EXPECT_NEAR(lambda[i], solution.lambda[i], kDifference * largest)
        << problem.constraint_name(static_cast<int>(i));
  }
}

TEST_P(ArcStartOf, CostatesAreTheGradientOfTheTime) {
  // dT/dφ of optimal times between fixed ends, by central differences, whose
  // error is h²/6 T''' with T''' of the order of T.
  if (!GetParam().body.rolls()) return;
  constexpr double kStep = 1e-3;
  const auto time = [&](double phi) {
    ArcLength problem(GetParam(), 60, phi);
    const PrimalDual solution = solve_arc(problem);
    EXPECT_TRUE(problem.set_point(solution.x));
    return problem.eval_f();
  };
  ArcLength problem(GetParam(), 60, kPhi);
  const PrimalDual solution = solve_arc(problem);
  ASSERT_TRUE(problem.set_point(solution.x));
  const Costates p = problem.end_costates(solution.lambda);

  const double slope =
      (time(kPhi + kStep) - time(kPhi - kStep)) / (2.0 * kStep);

  EXPECT_NEAR(-GetParam().body.radius *
                  (p.p_x * std::cos(kPhi) + p.p_z * std::sin(kPhi)),
              slope, 10.0 * kStep * kStep);
}

TEST_P(ArcStartOf, ProlongationToTheSameMeshChangesNothing) {
  ArcLength coarse(GetParam(), 60, kPhi);
  const PrimalDual solution = solve_arc(coarse);
  ArcLength same(GetParam(), 60, kPhi);

  const PrimalDual start = prolong(coarse, solution, same);

  for (std::size_t i = 0; i < start.x.size(); ++i) {
    EXPECT_NEAR(start.x[i], solution.x[i], 1e-11)
        << same.variable_name(static_cast<int>(i));
  }
}

TEST_P(ArcStartOf, AFinerMeshNeedsFewIterationsFromACoarserOne) {
  ArcLength coarse(GetParam(), 200, kPhi);
  const PrimalDual solution = solve_arc(coarse);
  ArcLength fine(GetParam(), 400, kPhi);

  const SolverResult result =
      solve_with_ipopt(fine, prolong(coarse, solution, fine), {});

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  // Newton's method from an error of some 1e-5: three steps, one to spare for
  // the first pieces, where the start is worse.
  EXPECT_LE(result.iterations, 5);
}

TEST_P(ArcStartOf, WhatTheFirstPiecesAreOffByGoesOverToAFinerMesh) {
  // The first nodes lie beside the path by an angle like 1/N, and derivatives
  // of the time by them are of the order of N times that: of a path without it
  // the residual would be the same on all meshes. The nodes that the path next
  // to the start goes through lie beside it by the square of one over their
  // number, which on these meshes grows with N.
  const SolvedProblem smooth = solved(GetParam(), uniform_mesh(5, 16), kPhi);
  NewtonOptions newton;
  newton.tolerance = 1e-9;
  std::array<double, 4> h{}, residual{};
  for (std::size_t level = 0; level < h.size(); ++level) {
    const int pieces = 256 << level;
    ArcLength coarse(GetParam(), pieces, kPhi);
    const ExtremalCurve curve(smooth.problem, smooth.point);
    const NewtonResult found =
        solve_with_newton(coarse, prolong(curve, coarse), newton);
    ASSERT_EQ(found.status, Status::Solved);
    for (const int times : {4, 16}) {
      ArcLength fine(GetParam(), times * pieces, kPhi);
      const PrimalDual start = prolong(coarse, found.point, fine);
      residual[level] =
          std::max(residual[level], nlp::kkt_residual(fine, start).max());
    }
    h[level] = 1.0 / pieces;
  }
  EXPECT_GT(observed_order(h, residual), 1.9)
      << residual[0] << ' ' << residual[1] << ' ' << residual[2] << ' '
      << residual[3];
}

TEST_P(ArcStartOf, TheSolutionIsAStrictMinimumOnFineMeshesToo) {
  for (const int pieces : {60, 1000}) {
    ArcLength problem(GetParam(), pieces, kPhi);
    const PrimalDual solution = solve_arc(problem);

    const Inertia inertia = kkt_inertia(problem, solution);

    ASSERT_TRUE(inertia.known);
    EXPECT_EQ(inertia.positive, problem.num_variables() - 2) << pieces;
    EXPECT_EQ(inertia.negative, problem.num_constraints()) << pieces;
    EXPECT_EQ(inertia.zero, 0) << pieces;
  }
}

}  // namespace
}  // namespace brachisto::testing
