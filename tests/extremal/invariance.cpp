// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"

namespace brachisto {
namespace {

using testing::base_scene;
using testing::scene_of;

TEST(Result, DoesNotDependOnTheUnitOfLengthOrOnGravity) {
  // Factors that are no powers of two, so that rounding differs.
  constexpr double kFactor = 1234.5;
  const Scene scene = base_scene(0.4);
  Scene other = scene;
  other.L *= kFactor;
  other.H *= kFactor;
  other.body.radius *= kFactor;
  other.gravity = 1.62;

  const ExtremalSolution one = solve_extremal(scene);
  const ExtremalSolution two = solve_extremal(other);

  ASSERT_TRUE(one.solved()) << one.message;
  ASSERT_TRUE(two.solved()) << two.message;
  EXPECT_NEAR(two.tau / one.tau, 1.0, 1e-13);
  EXPECT_NEAR(two.phi, one.phi, 1e-12);
  EXPECT_NEAR(two.rotation, one.rotation, 1e-11);
  EXPECT_NEAR(two.centre_path_length / kFactor, one.centre_path_length, 1e-12);
  const double time_unit = std::sqrt(kFactor * scene.gravity / other.gravity);
  EXPECT_NEAR(two.p_x * kFactor / time_unit, one.p_x, 1e-12);
  const ExtremalState a = one.path.at(0.37);
  const ExtremalState b = two.path.at(0.37);
  EXPECT_NEAR(b.w * time_unit / kFactor, a.w, 1e-11);
  EXPECT_NEAR(b.p_theta / time_unit, a.p_theta, 1e-12);
  EXPECT_NEAR(b.t / time_unit, a.t, 1e-12);
}

TEST(Result, DoesNotDependOnTheNumberOfArcs) {
  const Scene scene = base_scene();
  const ExtremalSolution usual = solve_extremal(scene);
  for (const int arcs : {1, 3, 20}) {
    const ExtremalSolution found = solve_extremal(scene, {.arcs = arcs});

    ASSERT_TRUE(found.solved()) << found.message;
    EXPECT_EQ(found.arcs, arcs);
    EXPECT_NEAR(found.tau / usual.tau, 1.0, 1e-13) << arcs << " arcs";
    EXPECT_NEAR(found.phi, usual.phi, 1e-12) << arcs << " arcs";
  }
}

TEST(Result, IsFreeOfTheStartingAngleWithoutOffset) {
  const Body body = Body::cylinder(0.3, 0.0, 1.1, 0.4);
  Body turned = body;
  turned.theta_m = -0.7;

  const ExtremalSolution one = solve_extremal(scene_of(body, 2.5));
  const ExtremalSolution two = solve_extremal(scene_of(turned, 2.5));

  ASSERT_TRUE(one.solved() && two.solved());
  EXPECT_NEAR(two.tau / one.tau, 1.0, 1e-14);
}

TEST(ErrorEstimate, BoundsTheErrorAtLooseTolerances) {
  const Scene scene = base_scene();
  const double exact = solve_extremal(scene).tau;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
    const ExtremalSolution found =
        solve_extremal(scene, {.tolerance = tolerance});

    ASSERT_TRUE(found.solved()) << found.message;
    EXPECT_LE(found.error_estimate, tolerance);
    // Twice, for the rounding of the reference itself.
    EXPECT_LE(std::abs(found.tau / exact - 1.0),
              2.0 * found.error_estimate + 1e-14)
        << "tolerance " << tolerance;
  }
}

/// Folds are followed from scenes whose limits come later.
TEST(Result, OfContactsThatNeedLimitsIsThatOfTheSmoothOne) {
  const ExtremalSolution smooth = solve_extremal(base_scene());
  Scene optimal = base_scene(), given = base_scene();
  optimal.contact = Contact::Optimal;
  given.contact = Contact::EndSlope;
  given.end_slope = -0.5;

  for (const Scene& scene : {optimal, given}) {
    const ExtremalSolution found = solve_extremal(scene);

    ASSERT_TRUE(found.solved()) << found.message;
    EXPECT_EQ(found.tau, smooth.tau);
    EXPECT_EQ(found.phi, smooth.phi);
  }
}

}  // namespace
}  // namespace brachisto
