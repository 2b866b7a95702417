// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What the answer cannot depend on.

#include <gtest/gtest.h>

#include <cmath>

#include "brachisto/study/solve.hpp"
#include "study/answer_kinds.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

// Scenes that mean the same are solved in natural units from numbers that
// differ by roundings. The iterations then stop at points whose residuals are
// below 1e-12; T is stationary, so they differ in τ by no more than that times
// multipliers of order one. Path figures are not stationary: ten times more.
constexpr double kTimeRounding = 1e-12;
constexpr double kPathRounding = 1e-11;

Scene off_centred() {
  return testing::reference("theta_-30").scene();
}

void expect_same_path(const Solution& solution, const Solution& expected,
                      double scale) {
  ASSERT_TRUE(solution.verified()) << solution.message;
  ASSERT_TRUE(expected.verified()) << expected.message;
  const Trajectory& path = *trajectory_of(solution);
  const Trajectory& other = *trajectory_of(expected);
  EXPECT_NEAR(path.tau(), other.tau(), kTimeRounding * other.tau());
  EXPECT_NEAR(path.end_angle(), other.end_angle(), kPathRounding);
  EXPECT_NEAR(path.centre_path_length() / scale, other.centre_path_length(),
              kPathRounding * other.centre_path_length());
  EXPECT_NEAR(path.rail_length() / scale, other.rail_length(),
              kPathRounding * other.rail_length());
}

TEST(Tau, IsFreeOfGravity) {
  Scene scene = off_centred();
  const Solution earth = solve(scene);
  for (const double gravity : {1.62, 274.0}) {
    scene.gravity = gravity;

    const Solution elsewhere = solve(scene);

    expect_same_path(elsewhere, earth, 1.0);
    // T ~ 1/√g, the law of free fall.
    EXPECT_NEAR(elsewhere.motion()->transit_time() * std::sqrt(gravity),
                earth.motion()->transit_time() * std::sqrt(9.81),
                kTimeRounding * 10.0);
  }
}

TEST(Tau, IsFreeOfTheUnitOfLength) {
  const Scene metres = off_centred();
  const Solution expected = solve(metres);
  for (const double scale : {1e-3, 1e3, 0.3048}) {
    Scene scene = metres;
    scene.L *= scale;
    scene.H *= scale;
    scene.body.radius *= scale;

    const Solution scaled = solve(scene);

    expect_same_path(scaled, expected, scale);
    // T ~ √length.
    EXPECT_NEAR(scaled.motion()->transit_time() / std::sqrt(scale),
                expected.motion()->transit_time(), kTimeRounding * 2.0);
  }
}

TEST(Tau, IsFreeOfTheMass) {
  Scene scene = off_centred();
  const Solution massless = solve(scene);
  scene.body.mass = 12.5;

  const Solution heavy = solve(scene);

  // The mass is no part of the equations: not even a rounding differs.
  EXPECT_EQ(heavy.motion()->tau(), massless.motion()->tau());
}

TEST(Tau, IsFreeOfTheStartingAngleOfACentredCylinder) {
  Scene scene = testing::reference("uniform_L3").scene();
  const Solution expected = solve(scene);
  for (const double theta_m : {-3.0, -0.7, 0.5, 1.5707963267948966, 3.1}) {
    scene.body.theta_m = theta_m;

    const Solution turned = solve(scene);

    expect_same_path(turned, expected, 1.0);
  }
}

TEST(Tau, IsTheSameForAnAngleAndItsEquivalentOneTurnOn) {
  Scene scene = off_centred();
  const Solution expected = solve(scene);
  scene.body.theta_m += 2.0 * std::acos(-1.0);

  const Solution turned = solve(scene);

  expect_same_path(turned, expected, 1.0);
}

}  // namespace
}  // namespace brachisto
