// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "refinement/mesh_solve.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <numbers>

#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "support/reference_values.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

class SolveOnMesh : public ::testing::Test {
 protected:
  [[nodiscard]] MeshSolution solve_cold() {
    const auto arc = axisymmetric_optimum(problem.scene());
    const double phi = arc->slope_angle(arc->psi_end);
    return solve_on_mesh(problem, {cycloid_guess(problem, *arc), phi}, {});
  }

  RollingTime problem{
      in_natural_units(testing::reference("reference_case").scene()),
      uniform_mesh(5, 24), 0.0};
};

TEST_F(SolveOnMesh, ClosesTheContact) {
  const MeshSolution solution = solve_cold();

  ASSERT_TRUE(solution.solved()) << solution.message;
  EXPECT_TRUE(solution.tangency.closed);
  // The error of the mesh, some 1e-12, and of the tangency, 1e-10 at the worst.
  EXPECT_NEAR(solution.tangency.phi,
              testing::reference("reference_case").end_angle, 1e-9);
}

TEST_F(SolveOnMesh, FromItsOwnSolutionNeedsOnePass) {
  const MeshSolution first = solve_cold();
  ASSERT_TRUE(first.solved()) << first.message;

  const MeshSolution again = solve_on_mesh(
      problem, {first.point, first.tangency.phi, first.tangency.slope}, {});

  ASSERT_TRUE(again.solved()) << again.message;
  EXPECT_EQ(again.tangency.passes, 1);
  EXPECT_LE(again.iterations, 1);
}

TEST_F(SolveOnMesh, IsNotMisledByASlopeAngleAWholeTurnOff) {
  // β enters only through its sine and cosine, so that an iteration may leave
  // single values in another turn; even the last one, next to β_end.
  const MeshSolution first = solve_cold();
  ASSERT_TRUE(first.solved()) << first.message;
  const int last = problem.layout().beta(problem.mesh().num_points() - 1);
  for (const double turn : {kTurn, -kTurn}) {
    PrimalDual turned = first.point;
    turned.x[static_cast<std::size_t>(last)] += turn;

    const MeshSolution again = solve_on_mesh(
        problem, {turned, first.tangency.phi, first.tangency.slope}, {});

    ASSERT_TRUE(again.solved()) << again.message;
    EXPECT_NEAR(again.tangency.phi, first.tangency.phi, 1e-9);
    EXPECT_EQ(again.tangency.passes, 1);
  }
}

}  // namespace
}  // namespace brachisto
