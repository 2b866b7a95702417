// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace brachisto {
namespace {

using report::obstacles;
using report::Outline;

constexpr Point kLow{-1.0, -1.0}, kHigh{3.0, 1.0};

/// Gauss's formula.
double area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Point a = outline[i];
    const Point b = outline[(i + 1) % outline.size()];
    twice += a.x * b.z - a.z * b.x;
  }
  return 0.5 * std::abs(twice);
}

/// Of its polygon of 120 corners.
double disc_area(double radius) {
  constexpr double kCorners = 120.0;
  return 0.5 * kCorners * radius * radius *
         std::sin(2.0 * std::numbers::pi / kCorners);
}

// Sums of a hundred products of order one.
constexpr double kRounding = 1e-13;

TEST(Obstacles, AreWhatLiesBelowTheFloor) {
  PathLimits limits;
  limits.floor = 0.75;

  const auto found = obstacles(limits, kLow, kHigh);

  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(area(found[0]), 4.0 * 0.25, kRounding);
  for (const Point p : found[0]) EXPECT_GE(p.z, 0.75 - kRounding);
}

TEST(Obstacles, AreWhatLiesBehindAHalfPlane) {
  PathLimits limits;
  // Through (−1, 0) and (0, −1); the corner (−1, −1) lies behind it.
  limits.half_planes = {{{-1.0, 0.0}, 0.25 * std::numbers::pi}};

  const auto found = obstacles(limits, kLow, kHigh);

  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(area(found[0]), 0.5, kRounding);
}

TEST(Obstacles, AreDiscsAsFarAsTheyLieInTheFrame) {
  PathLimits limits;
  limits.discs = {{{1.0, 0.0}, 0.5}, {{3.0, 0.0}, 0.5}, {{-1.0, 1.0}, 0.5}};

  const auto found = obstacles(limits, kLow, kHigh);

  ASSERT_EQ(found.size(), 3u);
  EXPECT_NEAR(area(found[0]), disc_area(0.5), kRounding);
  EXPECT_NEAR(area(found[1]), disc_area(0.5) / 2.0, kRounding);
  EXPECT_NEAR(area(found[2]), disc_area(0.5) / 4.0, kRounding);
}

TEST(Obstacles, AreNoneOutsideOfTheFrame) {
  PathLimits limits;
  limits.floor = 1.5;
  limits.discs = {{{5.0, 0.0}, 0.5}};
  limits.half_planes = {{{4.0, 0.0}, std::numbers::pi}};

  EXPECT_TRUE(obstacles(limits, kLow, kHigh).empty());
  EXPECT_TRUE(obstacles({}, kLow, kHigh).empty());
}

}  // namespace
}  // namespace brachisto
