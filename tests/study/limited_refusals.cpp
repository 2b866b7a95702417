// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What solve() says of limits that no track keeps, and what it advises.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "brachisto/study/solve.hpp"
#include "support/limited_scenes.hpp"

namespace brachisto {
namespace {

using namespace testing;

/// At rest a normal force bounds no turn: where C_A is best above another slope
/// than the path leaves it under, each wider bound of the valley is a faster
/// track, and without one there is none that is fastest.
TEST(LimitedRefusals, OfAKinkAtRestThatNoLimitBounds) {
  const Scene base = off_centred_scene();
  PathLimits limits = bends(1.0, 10.0);
  limits.normal_max = 3.0;
  double before = std::numeric_limits<double>::infinity();
  for (const double K : {10.0, 100.0}) {
    limits.curvature.valley = K;
    const Solution solution = solve(under(base, limits, Contact::Optimal));
    ASSERT_TRUE(solution.verified()) << K << ": " << solution.message;
    const double tau = solution.motion()->tau();
    EXPECT_LT(tau, before - 0.01) << K;
    before = tau;
  }

  // However short the arc that turns.
  limits.curvature.valley = 1e4;
  EXPECT_NE(solve(under(base, limits, Contact::Optimal)).status,
            Status::NoFastestTrack);
  limits.curvature.valley.reset();
  const Solution solution = solve(under(base, limits, Contact::Optimal));

  EXPECT_EQ(solution.status, Status::NoFastestTrack) << solution.message;
  EXPECT_EQ(solution.motion(), nullptr);
  EXPECT_NE(solution.message.find("To try: limits.curvature.valley"),
            std::string::npos);
}

TEST(LimitedRefusals, OfTooLittleFrictionNameNoTime) {
  // Where friction has to turn a body that rolls on a heavy side no track
  // grips.
  const Solution solution = solve(under(off_centred_scene(), friction(0.05)));

  EXPECT_EQ(solution.status, Status::Infeasible) << solution.message;
  EXPECT_FALSE(solution.verified());
  EXPECT_EQ(solution.motion(), nullptr);
  EXPECT_TRUE(solution.limits.empty());
  for (const char* told :
       {"The tightest limit is friction: 0.05 is asked for, "
        "and the path that came "
        "nearest ",
        " at x_b = ", "To try: a larger friction, a smaller eta_m"}) {
    EXPECT_NE(solution.message.find(told), std::string::npos)
        << solution.message;
  }
  // What was tried, not what exists.
  EXPECT_EQ(solution.message.find("no path"), std::string::npos);
}

TEST(LimitedRefusals, AdviseWhatTheBodyHas) {
  // On a straight slope of 1/3 a uniform body presses with cos 18° = 0.949.
  Scene scene = off_centred_scene();
  scene.body = Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5);
  scene.L = 3.0;
  scene.H = 1.0;
  scene.limits.normal_min = 0.97;

  const Solution solution = solve(scene);

  EXPECT_FALSE(solution.verified());
  EXPECT_NE(solution.message.find("To try: a smaller normal_force.min"),
            std::string::npos)
      << solution.message;
  EXPECT_EQ(solution.message.find("eta_m"), std::string::npos)
      << solution.message;
}

TEST(LimitedRefusals, WhereAMultiplierHasTheWrongSignAdviseMore) {
  Solution solution;
  solution.scene = under(uniform_scene(), friction(0.112));
  solution.certificate.add("multiplier_signs", 1e-3, 1e-6);

  EXPECT_EQ(solution.advice().find("a larger friction"), 0U);
}

TEST(LimitedRefusals, OfAFloorThatLeavesNoSmoothContactNameNoTime) {
  const Scene base = off_centred_scene();
  const Solution solution =
      solve(under(base, floor_at(0.67 + base.body.radius)));

  EXPECT_EQ(solution.status, Status::NoSmoothContact) << solution.message;
  EXPECT_NE(
      solution.message.find("To try: contact: optimal, with limits.curvature"),
      std::string::npos)
      << solution.message;
  EXPECT_FALSE(solution.verified());
  EXPECT_EQ(solution.motion(), nullptr);
}

}  // namespace
}  // namespace brachisto
