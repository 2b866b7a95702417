// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Polishing changes the last digits only, and for the better.

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "model/units.hpp"
#include "refinement/mesh_solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"
#include "trajectory/extended_residual.hpp"
#include "transcription/initial_guess.hpp"
#include "transcription/prolongation.hpp"

namespace brachisto {
namespace {

using testing::reference;

TEST(Polish, LeavesTheTransitTimeAsItIs) {
  // Both are solutions of the same finite problem to 1e-12 of the conditions,
  // at which T is stationary. Without polishing the contact is closed to 1e-10
  // at the worst, which T feels by r √A/w times as much: a third.
  constexpr double kTolerance = 1e-12;
  constexpr double kOpenContact = 0.5e-10;
  for (const auto* row : {&reference("bead_L3"), &reference("uniform_L3"),
                          &reference("reference_case"), &reference("fast"),
                          &reference("theta_90"), &reference("r_0.2")}) {
    SolveOptions options;
    auto& program = options.use<Collocation>();
    program.discretisation.degree = 6;
    program.discretisation.elements = 24;
    program.polish = true;
    const Solution polished = solve(row->scene(), options);
    options.use<Collocation>().polish = false;
    const Solution plain = solve(row->scene(), options);

    ASSERT_TRUE(polished.verified()) << row->name << polished.message;
    ASSERT_TRUE(plain.verified()) << row->name << plain.message;
    const double open = plain.certificate.find("closure")->value;
    EXPECT_LE(open, 1e-10) << row->name;
    EXPECT_NEAR(polished.motion()->tau() / plain.motion()->tau(), 1.0,
                kTolerance + std::min(open, kOpenContact))
        << row->name;
    const double before = plain.certificate.find("kkt_residual")->value;
    const double after = polished.certificate.find("kkt_residual")->value;
    // Rounding of sums of terms below ten.
    EXPECT_LE(after, std::max(before, 1e-14)) << row->name;
    EXPECT_LE(polished.certificate.find("closure")->value,
              std::max(open, 1e-14))
        << row->name;
  }
}

TEST(Polish, NeverLeavesALargerResidual) {
  for (const auto* row : {&reference("reference_case"), &reference("r_0.2"),
                          &reference("theta_-30"), &reference("uniform_L2")}) {
    for (const int degree : {1, 3, 6}) {
      const Scene scene = in_natural_units(row->scene());
      // From the solution of another mesh, on the branch.
      SolveOptions options;
      options.use<Collocation>().discretisation.tolerance = 1e-6;
      const Solution coarse = solve(row->scene(), options);
      ASSERT_TRUE(trajectory_of(coarse)) << row->name;
      const ExtremalCurve& curve = trajectory_of(coarse)->curve();
      RollingTime problem(scene, uniform_mesh(degree, 30),
                          coarse.motion()->end_angle());
      MeshOptions mesh_options;

      const MeshSolution solution = solve_on_mesh(
          problem,
          {prolong(curve, problem), coarse.motion()->end_angle(), -1.0},
          mesh_options);

      ASSERT_TRUE(solution.solved()) << row->name << solution.message;
      EXPECT_LE(solution.polish.residual_after, solution.polish.residual_before)
          << row->name << " degree " << degree;
      const ExtendedResidual residual =
          extended_residual(problem, solution.point);
      // Recomputed in long double; what remains is rounding of the unknowns,
      // times entries of D below 6 p² and of the Hessian below 100.
      EXPECT_LE(residual.stationarity, 1e-13) << row->name << ' ' << degree;
      EXPECT_LE(residual.defects, 1e-13) << row->name << ' ' << degree;
    }
  }
}

}  // namespace
}  // namespace brachisto
