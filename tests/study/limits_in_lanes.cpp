// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Scenes under limits that their free paths keep within are solved side by side
// too, and no others.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "study/in_lanes.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::reference;

std::optional<Solution> solved_in_lanes(
    const Scene& scene,
    SensitivityOrder sensitivities = SensitivityOrder::None) {
  SolveOptions options;
  options.use<Collocation>().in_lanes = true;
  options.use<Collocation>().sensitivities = sensitivities;
  return solve_in_lanes(std::vector<SceneToSolve>{{scene, options}}).front();
}

constexpr const testing::ReferenceValue& kUniform = reference("uniform_L3");

/// How deep below A the body comes whose mass is on its axis: its centre runs
/// on a cycloid from (r, 0), of radius R, beyond the lowest point, and arrives
/// at z = H − r cos φ where its slope is φ = (π − a)/2.
double deepest() {
  const double a = std::numbers::pi - 2.0 * kUniform.end_angle;
  const double R =
      (1.0 - kUniform.r * std::cos(kUniform.end_angle)) / (1.0 - std::cos(a));
  return kUniform.r + 2.0 * R;
}

Scene with_floor(double depth) {
  Scene scene = kUniform.scene();
  scene.limits.floor = depth;
  return scene;
}

TEST(LimitsInLanes, OfAFloorBelowTheCycloidTellsHowFarItIs) {
  const double depth = deepest() + 0.01;
  const std::optional<Solution> found = solved_in_lanes(with_floor(depth));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->verified());
  EXPECT_NEAR(found->motion()->tau() / kUniform.tau, 1.0, 1e-14);
  ASSERT_EQ(found->limits.size(), 1U);
  const LimitOnPath& floor = found->limits.front();
  EXPECT_EQ(floor.name, "floor");
  EXPECT_EQ(floor.bound, depth);
  EXPECT_TRUE(floor.active.empty());
  EXPECT_NEAR(floor.least_slack, 0.01, 1e-9);
  EXPECT_EQ(floor.price, 0.0);
}

/// The unit of length being L, a ten-thousandth of it is not clear.
TEST(LimitsInLanes, AreLeftToOwnSolvesWherePathsComeNearThem) {
  for (const double below : {0.00025, 0.0, -0.01}) {
    EXPECT_FALSE(solved_in_lanes(with_floor(deepest() + below))) << below;
  }
}

/// Leaving rest with a vertical slope takes R_n = 0.
TEST(LimitsInLanes, OfForcesThatDecideTheStartAreLeftToOwnSolves) {
  Scene scene = kUniform.scene();
  scene.limits.friction = 50.0;
  EXPECT_FALSE(solved_in_lanes(scene));
  scene.limits = {};
  scene.limits.normal_min = 0.0;
  EXPECT_FALSE(solved_in_lanes(scene));
  scene.limits.normal_min = -0.5;
  EXPECT_TRUE(solved_in_lanes(scene));
}

/// Other contacts are other answers, whatever limits there are.
TEST(LimitsInLanes, ChangeNothingAboutContactsThatLanesDoNotHave) {
  Scene scene = with_floor(10.0);
  ASSERT_TRUE(solved_in_lanes(scene));
  scene.contact = Contact::Optimal;
  EXPECT_FALSE(solved_in_lanes(scene));
  scene.contact = Contact::EndSlope;
  scene.end_slope = 0.1;
  EXPECT_FALSE(solved_in_lanes(scene));
}

TEST(LimitsInLanes, HaveNoDerivatives) {
  constexpr auto kAsked = SensitivityOrder::First;
  EXPECT_TRUE(solved_in_lanes(kUniform.scene(), kAsked));
  EXPECT_FALSE(solved_in_lanes(with_floor(10.0), kAsked));
}

}  // namespace
}  // namespace brachisto
