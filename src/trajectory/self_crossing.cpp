// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "trajectory/self_crossing.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "brachisto/math/clock.hpp"

namespace brachisto {

namespace {

/// Twice the signed area of the triangle abc.
double area(Point a, Point b, Point c) {
  return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

/// Where ab properly crosses cd, if it does.
std::optional<Point> crossing(Point a, Point b, Point c, Point d) {
  const double c_side = area(a, b, c);
  const double d_side = area(a, b, d);
  if (!(c_side * d_side < 0.0)) return std::nullopt;
  if (!(area(c, d, a) * area(c, d, b) < 0.0)) return std::nullopt;
  const double t = c_side / (c_side - d_side);
  return Point{c.x + t * (d.x - c.x), c.z + t * (d.z - c.z)};
}

/// Where a track stands still, as with 1 − r κ_c = 0, its points differ by less
/// than they are worth: they are one.
std::vector<Point> without_standing(const std::vector<Point>& all) {
  double extent = 0.0;
  for (const Point& p : all) {
    extent = std::max({extent, std::abs(p.x), std::abs(p.z)});
  }
  std::vector<Point> points;
  for (const Point& p : all) {
    if (points.empty() ||
        std::hypot(p.x - points.back().x, p.z - points.back().z) >
            kShortestFold * extent) {
      points.push_back(p);
    }
  }
  return points;
}

}  // namespace

std::optional<Point> self_crossing(const std::vector<Point>& all) {
  const std::vector<Point> points = without_standing(all);
  if (points.size() < 4) return std::nullopt;
  // Sweep in x: a segment meets only those that begin before it ends.
  struct Segment {
    double left, right;
    std::size_t index;
  };
  std::vector<Segment> segments;
  segments.reserve(points.size() - 1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto [left, right] = std::minmax(points[i].x, points[i + 1].x);
    segments.push_back({left, right, i});
  }
  std::sort(segments.begin(), segments.end(),
            [](const Segment& a, const Segment& b) {
              return a.left < b.left || (a.left == b.left && a.index < b.index);
            });
  for (std::size_t a = 0; a < segments.size(); ++a) {
    check_stop(a);
    for (std::size_t b = a + 1;
         b < segments.size() && segments[b].left <= segments[a].right; ++b) {
      const std::size_t i = segments[a].index;
      const std::size_t j = segments[b].index;
      if (i + 1 == j || j + 1 == i) continue;
      if (const auto found =
              crossing(points[i], points[i + 1], points[j], points[j + 1])) {
        return found;
      }
    }
  }
  return std::nullopt;
}

}  // namespace brachisto
