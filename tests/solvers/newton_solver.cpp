// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/newton_solver.hpp"

#include <gtest/gtest.h>

#include "model/cycloid.hpp"
#include "solvers/hock_schittkowski.hpp"
#include "solvers/inequality_problems.hpp"
#include "support/scenes.hpp"
#include "transcription/contact_equation.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::testing {
namespace {

TEST(NewtonSolver, FollowsTheCycloidAsTheEndMoves) {
  // Along a cycloid β is linear in the rolling time, so that on 20 elements of
  // degree 5, a tenth of a radian each, defects are (0.1)^10/10! of it: what is
  // left is the tolerance of 1e-12, of times of order one.
  constexpr double kAccuracy = 1e-11;
  Scene scene = natural(uniform_scene());
  const auto first = axisymmetric_optimum(scene);
  ASSERT_TRUE(first);
  double phi = first->slope_angle(first->psi_end);
  const Mesh mesh = uniform_mesh(5, 20);
  RollingTime problem(scene, mesh, phi);
  ContactEquation contact(problem);
  NewtonSolver solver(problem, &contact);
  PrimalDual point = cycloid_extremal(problem, *first);

  for (const double L : {3.1, 3.2, 2.9}) {
    scene.L = L;
    problem.move_to(scene, mesh, phi);

    const NewtonResult found = solver.solve(point, phi, {});

    ASSERT_EQ(found.status, Status::Solved) << L;
    EXPECT_GT(found.iterations, 1) << L;
    EXPECT_EQ(found.chain_steps, found.iterations) << L;
    const auto arc = axisymmetric_optimum(scene);
    ASSERT_TRUE(arc) << L;
    EXPECT_NEAR(found.phi, arc->slope_angle(arc->psi_end), kAccuracy) << L;
    EXPECT_NEAR(
        found.point
            .x[static_cast<std::size_t>(problem.layout().rolling_time())],
        arc->rolling_time(scene.gravity), kAccuracy)
        << L;
    point = found.point;
    phi = found.phi;
  }
}

TEST(NewtonSolver, HoldsWhatHoldsWhereItStarts) {
  // No inequality of problem 35 holds as an equation at its start, one does
  // near its solution, and again none.
  DenseProblem<Hs35> problem;
  NewtonSolver solver(problem, nullptr);
  const PrimalDual away{Hs35::kStart, {0.0}};
  const PrimalDual near{{1.3, 0.8, 0.45}, {0.2}};

  EXPECT_FALSE(solver.solve(away, 0.0, {}).active_set_holds);
  const NewtonResult found = solver.solve(near, 0.0, {});
  EXPECT_FALSE(solver.solve(away, 0.0, {}).active_set_holds);

  ASSERT_EQ(found.status, Status::Solved);
  for (std::size_t i = 0; i < Hs35::kSolution.size(); ++i) {
    EXPECT_NEAR(found.point.x[i], Hs35::kSolution[i], 1e-12);
  }
  EXPECT_NEAR(found.point.lambda[0], Hs35::kMultipliers[0], 1e-12);
}

}  // namespace
}  // namespace brachisto::testing
