// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>

#include "extremal/scenes.hpp"
#include "extremal/shooting.hpp"

namespace brachisto {
namespace {

using testing::base_scene;
using testing::scene_of;

/// A scene whose branch folds at η = 0.52073 and again at η = 0.50311.
Scene folded_scene(double eta_m) {
  return scene_of(Body::cylinder(0.4315, eta_m, 0.7195, 0.3727), 2.4888);
}

TEST(Continuation, ReportsTheBranchFromTheCycloid) {
  const Scene scene = base_scene();

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  const auto& points = found.continuation.points;
  ASSERT_GE(points.size(), 2U);
  EXPECT_EQ(points.front().eta, 0.0);
  EXPECT_NEAR(points.front().phi, cycloid_guess(scene).phi, 1e-7);
  EXPECT_NEAR(points.back().eta, scene.body.eta_m, 1e-12);
  EXPECT_NEAR(points.back().transit_time, found.transit_time, 1e-6);
  EXPECT_TRUE(std::is_sorted(
      points.begin(), points.end(),
      [](const auto& a, const auto& b) { return a.eta < b.eta; }));
  EXPECT_TRUE(found.continuation.folds.empty());
}

TEST(Continuation, FindsTheFoldAtWhichTheBranchTurnsBack) {
  const ExtremalSolution below = solve_extremal(folded_scene(0.5206));
  const ExtremalSolution above = solve_extremal(folded_scene(0.671));

  EXPECT_TRUE(below.solved()) << below.message;
  EXPECT_EQ(above.status, ExtremalStatus::BranchTurnsBack);
  ASSERT_EQ(above.continuation.folds.size(), 1U);
  EXPECT_NEAR(above.continuation.folds.front(), 0.5207345, 1e-6);
  EXPECT_NE(above.message.find("0.5207"), std::string::npos) << above.message;
}

TEST(Continuation, FollowsTheBranchThroughFoldsIfAsked) {
  const ExtremalSolution found =
      solve_extremal(folded_scene(0.671), {.follow_folds = true});

  ASSERT_TRUE(found.solved()) << found.message;
  ASSERT_EQ(found.continuation.folds.size(), 2U);
  EXPECT_NEAR(found.continuation.folds.back(), 0.5031141, 1e-6);
  EXPECT_NEAR(found.phi, -0.215389, 1e-6);
}

TEST(Continuation, DoesNotJumpBetweenBranchesThatNearlyCross) {
  // At η ≈ 0.1 another branch passes the one from the cycloid closely; it goes
  // on smoothly to τ = 6.736763 while the principal one bends. The value was
  // obtained with steps of a twentieth of the usual ones.
  const Scene scene =
      scene_of(Body::cylinder(0.1133162066512714, 0.7024757525254223,
                              0.6686456182118556, 0.1376364725845721),
               4.8342018915081155);

  const ExtremalSolution found = solve_extremal(scene);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau, 6.788648052, 1e-8);
}

TEST(Guess, FromANeighbouringSolutionConverges) {
  const Scene scene = base_scene(-0.2);
  const ExtremalSolution neighbour = solve_extremal(base_scene(-0.25));
  const ExtremalGuess guess{
      .rolling_time = neighbour.rolling_time,
      .phi = neighbour.phi,
      .state = [&](double sigma) { return neighbour.path.at(sigma); }};

  const ExtremalSolution found = solve_extremal(scene, guess);

  ASSERT_TRUE(found.solved()) << found.message;
  EXPECT_NEAR(found.tau / solve_extremal(scene).tau, 1.0, 1e-13);
  EXPECT_LE(found.newton_steps, 8);
  EXPECT_TRUE(found.continuation.points.empty());
}

}  // namespace
}  // namespace brachisto
