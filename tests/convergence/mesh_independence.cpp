// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The number of iterations does not grow with the mesh: the defects are in
// integral form, so that tolerances mean the same on every mesh.

#include <gtest/gtest.h>

#include "brachisto/study/solve.hpp"
#include "model/cycloid.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"
#include "support/reference_values.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto {
namespace {

// From the plain cycloid Newton's method needs five or six steps here; ten
// leave room for other builds of the linear algebra. With quadratic
// convergence the warm-started passes that close the contact need 3 + 3 + 2 +
// … more.
constexpr int kFirstIterations = 10;
constexpr int kAllIterations = 25;

class MeshIndependence : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Elements, MeshIndependence,
                         ::testing::Values(10, 100, 500, 2000));

TEST_P(MeshIndependence, HoldsForTheIterationsOfAllPasses) {
  const Scene scene =
      in_natural_units(testing::reference("reference_case").scene());
  const auto arc = axisymmetric_optimum(scene);
  ASSERT_TRUE(arc);
  const double phi = arc->slope_angle(arc->psi_end);
  RollingTime problem(scene, uniform_mesh(5, GetParam()), phi);

  const MeshSolution solution =
      solve_on_mesh(problem, {cycloid_guess(problem, *arc), phi}, {});

  ASSERT_TRUE(solution.solved()) << solution.message;
  EXPECT_LE(solution.first_iterations, kFirstIterations);
  EXPECT_LE(solution.iterations, kAllIterations);
  EXPECT_EQ(solution.refused_points, 0);
}

TEST(MeshIndependence, HoldsForAWholeSolve) {
  // Between meshes the curve of one is the start on the other, which is off by
  // no more than the coarse one: Newton's method doubles its digits, and with a
  // coarse curve good to 1e-5 two steps do.
  constexpr int kFromACurve = 3;
  for (const int elements : {20, 100, 500}) {
    SolveOptions options;
    options.use<Collocation>().discretisation.elements = elements;

    const Solution solution =
        solve(testing::reference("reference_case").scene(), options);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_LE(solution.effort.final_mesh().first_iterations, kFromACurve)
        << elements;
    EXPECT_LE(solution.effort.iterations, 2 * kFromACurve) << elements;
    ASSERT_EQ(solution.effort.meshes.size(), 1u);
    // Polishing, and the check with one degree more.
    EXPECT_LE(solution.effort.meshes.front().newton_steps, 2 * kFromACurve)
        << elements;
  }
}

}  // namespace
}  // namespace brachisto
