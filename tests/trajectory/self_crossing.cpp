// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/self_crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "math/cpu_clock.hpp"
#include "support/random_points.hpp"
#include "support/scenes.hpp"

namespace brachisto::testing {
namespace {

using Line = std::vector<Point>;

/// (cos t, sin 2t), which crosses itself at the origin.
Line figure_eight(int count) {
  Line out;
  // Not closed, and no point at the origin.
  for (int i = 0; i <= count; ++i) {
    const double t = 0.1 + (2.0 * kPi - 0.2) * i / count;
    out.push_back({std::cos(t), std::sin(2.0 * t)});
  }
  return out;
}

TEST(SelfCrossing, OfAFigureEightIsInItsMiddle) {
  for (const int count : {17, 100, 1001}) {
    const auto found = self_crossing(figure_eight(count));

    ASSERT_TRUE(found) << count;
    // Chords leave the curve by their length squared over eight, times a
    // curvature of two and a half.
    const double chord = 2.0 * kPi * 2.0 / count;
    EXPECT_NEAR(found->x, 0.0, chord * chord) << count;
    EXPECT_NEAR(found->z, 0.0, chord * chord) << count;
  }
}

TEST(SelfCrossing, OfTwoSegmentsIsWhereTheyMeet) {
  const auto found = self_crossing({{0, 0}, {4, 4}, {4, 0}, {0, 2}});

  ASSERT_TRUE(found);
  EXPECT_NEAR(found->x, 4.0 / 3.0, 1e-15);
  EXPECT_NEAR(found->z, 4.0 / 3.0, 1e-15);
}

TEST(SelfCrossing, IsTheFirstOneInTheOrderOfX) {
  // A zigzag back over a straight line.
  const auto found = self_crossing(
      {{0, 0}, {10, 0}, {9, 1}, {8, -1}, {3, 1}, {2, -1}, {1, 1}});

  ASSERT_TRUE(found);
  EXPECT_LT(found->x, 10.0);
}

TEST(SelfCrossing, IsNotSeenWhereNoneIs) {
  // An open line, a closed triangle, a spiral, and shapes of few points.
  Line spiral;
  for (int i = 0; i < 400; ++i) {
    const double t = 0.05 * i;
    spiral.push_back({(1.0 + t) * std::cos(t), (1.0 + t) * std::sin(t)});
  }
  for (const Line& line : {Line{}, Line{{0, 0}}, Line{{0, 0}, {1, 1}},
                           Line{{0, 0}, {1, 1}, {2, 0}},
                           Line{{0, 0}, {1, 1}, {2, 0}, {0, 0}}, spiral}) {
    EXPECT_FALSE(self_crossing(line)) << line.size() << " points";
  }
}

TEST(SelfCrossing, IsNotATouchWithoutPassing) {
  // A point on another segment, the line coming back to the side it came from,
  // and the same stretch walked twice.
  EXPECT_FALSE(self_crossing({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}));
  EXPECT_FALSE(
      self_crossing({{0, 0}, {4, 0}, {5, 0}, {5, 1}, {4, 1}, {4, 0}, {3, 1}}));
  EXPECT_FALSE(self_crossing({{0, 0}, {1, 0}, {2, 0}, {1, 0}, {0, 0}}));
}

TEST(SelfCrossing, IsNotOfPointsThatRoundingAloneKeepsApart) {
  // A corner, where the line stands and its points tremble by some ε; a loop of
  // a millionth of the line is one.
  const auto with_loop = [](double size) {
    return Line{{0, 0}, {4, 0}, {4 + size, size}, {4, size}, {4 + size, 0},
                {4, 3}, {5, 3}};
  };

  EXPECT_FALSE(self_crossing(with_loop(1e-15)));
  EXPECT_TRUE(self_crossing(with_loop(1e-6)));
}

TEST(SelfCrossing, DoesNotDependOnHowTheLineIsTurned) {
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.3 + 2.0 * kPi * i / 12.0;
    Line line = figure_eight(60);
    for (Point& p : line) {
      p = {std::cos(angle) * p.x - std::sin(angle) * p.z,
           std::sin(angle) * p.x + std::cos(angle) * p.z};
    }

    EXPECT_TRUE(self_crossing(line)) << i;
  }
}

TEST(SelfCrossing, AgreesWithAllPairs) {
  const auto area = [](Point a, Point b, Point c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
  };
  int crossed = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    Random random(seed);
    Line line{{0.0, 0.0}};
    for (int i = 0; i < 12; ++i) {
      line.push_back({line.back().x + random.uniform(-0.3, 1.0),
                      line.back().z + random.uniform(-1.0, 1.0)});
    }
    bool expected = false;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      for (std::size_t j = i + 2; j + 1 < line.size(); ++j) {
        const bool apart = area(line[i], line[i + 1], line[j]) *
                                   area(line[i], line[i + 1], line[j + 1]) >=
                               0.0 ||
                           area(line[j], line[j + 1], line[i]) *
                                   area(line[j], line[j + 1], line[i + 1]) >=
                               0.0;
        expected = expected || !apart;
      }
    }

    EXPECT_EQ(self_crossing(line).has_value(), expected) << "seed " << seed;
    crossed += expected ? 1 : 0;
  }
  EXPECT_GT(crossed, 30);
  EXPECT_LT(crossed, 270);
}

TEST(SelfCrossing, OfALongLineIsLookedForInLittleTime) {
  // All pairs of this would be 4·10¹⁰.
  constexpr int kPoints = 200000;
  Line line;
  line.reserve(kPoints);
  for (int i = 0; i < kPoints; ++i) {
    const double x = 1e-3 * i;
    line.push_back({x, std::sin(x)});
  }

  const double begin = process_cpu_seconds();
  const auto found = self_crossing(line);
  const double seconds = process_cpu_seconds() - begin;

  EXPECT_FALSE(found);
  // Some 10 ms, a hundred times that in a checked build.
  EXPECT_LT(seconds, 5.0);
}

}  // namespace
}  // namespace brachisto::testing
