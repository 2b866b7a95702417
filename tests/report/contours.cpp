// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/contours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

namespace brachisto::report {
namespace {

using Line = std::vector<Pixel>;

/// Values of a function on an even grid over [−1, 1]².
Lattice sampled(std::size_t count,
                const std::function<double(double, double)>& f) {
  Lattice lattice{count, count, {}, {}};
  const double step = 2.0 / static_cast<double>(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const Pixel p{-1.0 + step * static_cast<double>(i),
                    -1.0 + step * static_cast<double>(j)};
      lattice.nodes.push_back(p);
      lattice.values.push_back(f(p.x, p.y));
    }
  }
  return lattice;
}

double radius(Pixel p) {
  return std::hypot(p.x, p.y);
}

bool closed(const Line& line) {
  return line.front().x == line.back().x && line.front().y == line.back().y;
}

TEST(Contours, OfALinearFunctionAreStraightLinesFromBorderToBorder) {
  const Lattice lattice =
      sampled(8, [](double x, double y) { return 2.0 * x + y; });

  const auto lines = contour_lines(lattice, 0.3);

  ASSERT_EQ(lines.size(), 1u);
  for (const Pixel& p : lines[0]) EXPECT_NEAR(2.0 * p.x + p.y, 0.3, 1e-14);
  EXPECT_EQ(std::abs(lines[0].front().y), 1.0);
  EXPECT_EQ(std::abs(lines[0].back().y), 1.0);
}

TEST(Contours, OfACircleAreCirclesToSecondOrder) {
  constexpr double kRadius = 0.7;
  for (const std::size_t n : {11, 21, 41}) {
    const auto lines = contour_lines(
        sampled(n, [](double x, double y) { return x * x + y * y; }),
        kRadius * kRadius);

    ASSERT_EQ(lines.size(), 1u);
    EXPECT_TRUE(closed(lines[0]));
    // Along an edge the function is x² + constant: linear interpolation is out
    // by at most h²/4, the radius by that over the gradient 2 r.
    const double h = 2.0 / static_cast<double>(n - 1);
    for (const Pixel& p : lines[0]) {
      EXPECT_NEAR(radius(p), kRadius, 0.25 * h * h / (2.0 * kRadius) * 1.05);
    }
  }
}

TEST(Contours, GoRoundALevelOnce) {
  const auto lines = contour_lines(
      sampled(41, [](double x, double y) { return x * x + y * y; }), 0.49);

  double turned = 0.0;
  for (std::size_t i = 1; i < lines.at(0).size(); ++i) {
    const Pixel a = lines[0][i - 1], b = lines[0][i];
    turned += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }

  EXPECT_NEAR(std::abs(turned), 2.0 * std::acos(-1.0), 1e-12);
}

TEST(Contours, OfASaddleFollowTheMeanOfTheCorners) {
  Lattice lattice{2, 2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}}, {1, 0, 0, 1}};

  // The mean ½ is above 0.4: the upper corners (0,0) and (1,1) are joined, so
  // each line cuts off a lower corner, and x + y − 1 has one sign change
  // between the lines and none on either.
  for (const double level : {0.4, 0.6}) {
    const auto lines = contour_lines(lattice, level);

    ASSERT_EQ(lines.size(), 2u);
    for (const Line& line : lines) {
      ASSERT_EQ(line.size(), 2u);
      const double a =
          level < 0.5 ? line[0].x - line[0].y : line[0].x + line[0].y - 1.0;
      const double b =
          level < 0.5 ? line[1].x - line[1].y : line[1].x + line[1].y - 1.0;
      EXPECT_GT(a * b, 0.0) << "level " << level;
    }
  }
}

TEST(Contours, StopAtWhatHasNoValue) {
  Lattice lattice = sampled(21, [](double x, double) { return x; });
  const std::size_t hole = lattice.at(10, 10);
  lattice.values[hole] = std::numeric_limits<double>::quiet_NaN();

  const auto lines = contour_lines(lattice, 0.03);

  ASSERT_EQ(lines.size(), 2u);
  const double h = 0.1;
  for (const Line& line : lines) {
    for (const Pixel& p : line) EXPECT_GE(std::abs(p.y), h - 1e-12);
  }
}

TEST(Contours, AreNoneWhereNothingIsKnownOrReached) {
  const auto constant = [](double, double) { return 1.0; };
  const auto nothing = [](double, double) {
    return std::numeric_limits<double>::quiet_NaN();
  };

  EXPECT_TRUE(contour_lines(sampled(5, constant), 1.0).empty());
  EXPECT_TRUE(contour_lines(sampled(5, nothing), 1.0).empty());
  EXPECT_TRUE(contour_lines(sampled(5, std::plus<>{}), 3.0).empty());
}

TEST(Cells, FillTheGridAndNoMore) {
  // The bent grid (x, f (1 − x²)) of polygons: their area by the trapezoid
  // rule.
  constexpr std::size_t kNx = 9, kNy = 5;
  Lattice lattice{kNx, kNy, {}, {}};
  double expected = 0.0;
  const auto top = [](std::size_t i) {
    const double x = static_cast<double>(i) / kNx;
    return 1.0 - x * x;
  };
  for (std::size_t i = 0; i < kNx; ++i) {
    for (std::size_t j = 0; j < kNy; ++j) {
      lattice.nodes.push_back({static_cast<double>(i) / kNx,
                               top(i) * static_cast<double>(j) / (kNy - 1)});
    }
    if (i > 0) expected += 0.5 * (top(i - 1) + top(i)) / kNx;
  }

  const Cells cells(lattice);
  double area = 0.0;
  for (std::size_t i = 0; i < kNx; ++i) {
    for (std::size_t j = 0; j < kNy; ++j) {
      const auto outline = cells.outline(i, j);
      for (std::size_t c = 0; c < 4; ++c) {
        const Pixel a = outline[c], b = outline[(c + 1) % 4];
        area += 0.5 * (a.x * b.y - a.y * b.x);
      }
    }
  }

  // Corners lie in the middle of edges, so the border bends at other places.
  const double h = 1.0 / kNx;
  EXPECT_NEAR(area, expected, 0.25 * h * h);
  EXPECT_EQ(cells.corner(0, 0).x, 0.0);
  EXPECT_EQ(cells.corner(kNx, kNy).x, lattice.nodes.back().x);
  EXPECT_EQ(cells.corner(kNx, kNy).y, lattice.nodes.back().y);
}

}  // namespace
}  // namespace brachisto::report
