// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The indirect method as the method, and as a cross-check.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "brachisto/study/solve.hpp"
#include "extremal/shooting.hpp"
#include "support/reference_values.hpp"
#include "support/scenes.hpp"

namespace brachisto {
namespace {

using testing::reference;
using testing::scene_of;

TEST(MethodExtremal, AnswersOnAMeshThatRepresentsItsExtremal) {
  // A large body that starts with its centre of mass opposite to where it
  // rolls: on sixteen elements per turn the residual is 1e-7.
  Scene scene = scene_of(Body::cylinder(0.74724, 0.68147, 2.77604, 0.18670));
  scene.L = 2.82062;
  SolveOptions options;
  options.method = Shooting{};

  const Solution solution = solve(scene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  const Solution other = solve(scene);
  ASSERT_TRUE(other.verified()) << other.message;
  EXPECT_NEAR(solution.motion()->tau(), other.motion()->tau(),
              2.0 * kDefaultTolerance * other.motion()->tau());
}

TEST(MethodExtremal, ReportsItsOwnTime) {
  const Scene scene = reference("theta_-30").scene();
  SolveOptions options;
  options.method = Shooting{};
  ExtremalOptions shooting;
  shooting.follow_folds = true;
  const ExtremalSolution extremal = solve_extremal(scene, shooting);
  ASSERT_TRUE(extremal.solved()) << extremal.message;

  const Solution solution = solve(scene, options);

  ASSERT_TRUE(solution.verified()) << solution.message;
  EXPECT_EQ(solution.motion()->transit_time(), extremal.transit_time);
  EXPECT_GE(*solution.estimated_error, extremal.error_estimate);
}

TEST(AnExtremal, IsUsableIfItsErrorIsKnownAndSmall) {
  ExtremalSolution extremal;
  extremal.status = ExtremalStatus::AccuracyNotReached;
  extremal.error_estimate = 2.6e-13;  // where 1e-13 was asked for
  EXPECT_TRUE(extremal.usable());

  for (const double error : {1e-3, std::numeric_limits<double>::quiet_NaN()}) {
    extremal.error_estimate = error;
    EXPECT_FALSE(extremal.usable()) << error;
  }
  extremal.error_estimate = 1e-14;
  extremal.status = ExtremalStatus::NotMinimal;
  EXPECT_FALSE(extremal.usable());
}

TEST(WholeTurns, OfTheStartChangeNothing) {
  constexpr double kTurns = 200.0 * std::numbers::pi;
  const auto& row = reference("reference_case");
  Scene scene = row.scene();
  scene.body.theta_m += kTurns;
  SolveOptions certified;
  certified.use<Collocation>().certify = Certify::Extremal;
  SolveOptions shooting;
  shooting.method = Shooting{};
  for (const SolveOptions& options : {certified, shooting}) {
    const Solution solution = solve(scene, options);

    ASSERT_TRUE(solution.verified()) << solution.message;
    EXPECT_NEAR(solution.motion()->tau(), row.tau,
                2.0 * kDefaultTolerance * row.tau);
    ASSERT_EQ(solution.warnings.size(), 1U);
    EXPECT_NE(solution.warnings[0].find("more than a turn"), std::string::npos);
    // The user's own angle is the one that is reported.
    EXPECT_EQ(solution.scene.body.theta_m, scene.body.theta_m);
    EXPECT_NEAR(solution.motion()->at(0.0).theta, scene.body.theta_m, 1e-12);
  }
}

}  // namespace
}  // namespace brachisto
