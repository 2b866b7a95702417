// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A body that turns many times is followed turn by turn.

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "refinement/turn_meshes.hpp"
#include "search/continuation.hpp"
#include "transcription/initial_guess.hpp"

namespace brachisto {
namespace {

Scene base(double radius) {
  Scene scene;
  scene.body = Body::cylinder(radius, 2.0 / 3.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

TEST(EqualTurns, AreThoseOfTheCycloid) {
  // Along the cycloid s = 4a (1 − cos ψ/2), and σ = ψ/ψ_end.
  const Scene scene = in_natural_units(base(0.01));
  const CycloidArc arc = *axisymmetric_optimum(scene);
  const RollingTime problem(scene, coarse_mesh(scene, arc), 0.0);

  const Mesh mesh = mesh_of_equal_turns(problem, cycloid_guess(problem, arc).x);

  const double whole = arc.arc_length(arc.psi_end);
  // Polynomials of degree 5 on some 300 elements.
  constexpr double kInterpolation = 1e-10;
  ASSERT_EQ(mesh.num_elements(), problem.mesh().num_elements());
  for (int e = 0; e <= mesh.num_elements(); ++e) {
    const double sigma = mesh.boundaries[static_cast<std::size_t>(e)];
    EXPECT_NEAR(arc.arc_length(sigma * arc.psi_end) / whole,
                1.0 * e / mesh.num_elements(), kInterpolation)
        << e;
  }
}

TEST(ContinuationByTurns, StaysOnTheBranchThatTheIndirectMethodFollows) {
  // 28 and 57 turns; the coarse mesh has T to six digits or so.
  constexpr double kCoarse = 1e-6;
  for (const double radius : {0.02, 0.01}) {
    const Scene scene = in_natural_units(base(radius));
    const CycloidArc arc = *axisymmetric_optimum(scene);
    ASSERT_TRUE(are_many(turns(scene.body, arc.arc_length(arc.psi_end))));

    const Continuation found =
        continue_from_cycloid(scene, arc, coarse_mesh(scene, arc), {});
    const ExtremalSolution witness = solve_extremal(scene);

    ASSERT_TRUE(found.curve) << found.message;
    ASSERT_TRUE(witness.usable()) << witness.message;
    EXPECT_NEAR(found.curve->transit_time() / witness.transit_time, 1.0,
                kCoarse);
    EXPECT_NEAR(found.phi, witness.phi, 1e-4);
    EXPECT_NEAR(found.curve->arc_length() / witness.centre_path_length, 1.0,
                kCoarse);
  }
}

TEST(ContinuationByTurns, TakesStepsThatHardlyDependOnTheTurns) {
  // At a fixed share of the rolling time they shrink with √r.
  const auto steps = [](double radius) {
    const Scene scene = in_natural_units(base(radius));
    const CycloidArc arc = *axisymmetric_optimum(scene);
    const Continuation found =
        continue_from_cycloid(scene, arc, coarse_mesh(scene, arc), {});
    EXPECT_TRUE(found.curve) << found.message;
    return found.steps.size();
  };

  const std::size_t few = steps(0.02);
  const std::size_t many = steps(0.0025);

  EXPECT_LE(many, 2 * few);
}

TEST(ContinuationByTurns, LeadsToAnAnswerAboveTheHomogenisedLimit) {
  // 284 turns: docs/numerics.md, section 6, where the value is that of the
  // continuation on a fixed mesh.
  constexpr double kLimit = 5.8461395;
  constexpr double kPrinted = 5e-7;

  const Solution solution = solve(base(0.002));

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_NEAR(solution.motion()->tau(), 5.852381, kPrinted);
  EXPECT_GT(solution.motion()->tau(), kLimit);
}

TEST(AnOffsetNextToNothing, ChangesTheTimeByNextToNothing) {
  // Many turns; at η_m = 0 the time of the cycloid, and dτ/dη is of order τ.
  Scene scene = base(0.05);
  scene.L = 10.0;
  scene.body.eta_m = 0.0;
  const Solution uniform = solve(scene);
  ASSERT_TRUE(uniform.verified());
  const double tau = uniform.motion()->tau();
  for (const double eta : {1e-6, 1e-7, 1e-8, 1e-14, 1e-50}) {
    scene.body.eta_m = eta;

    const Solution solution = solve(scene);

    ASSERT_TRUE(solution.verified()) << eta << ": " << solution.message;
    EXPECT_NEAR(solution.motion()->tau() / tau, 1.0,
                eta + 2.0 * kDefaultTolerance)
        << eta;
  }
}

}  // namespace
}  // namespace brachisto
