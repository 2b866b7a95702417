// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/cutting_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "report/cutting_drawing.hpp"

namespace brachisto::report::cutting {

namespace {

constexpr double kChord = 0.005;    ///< from the track [mm]
constexpr double kBetween = 150.0;  ///< fasteners at most [mm]

EdgePoint edge_point(const TrajectoryPoint& at, double per_metre) {
  return {at.sigma,
          {per_metre * at.motion.contact.x, per_metre * at.motion.contact.z},
          at.beta};
}

/// How far the middle of an arc is from its chord, at either edge of a strip.
double sagitta(const EdgePoint& a, const EdgePoint& middle, const EdgePoint& b,
               double depth) {
  const auto at = [&](double d) {
    const Point p = a.at_depth(d), q = b.at_depth(d), m = middle.at_depth(d);
    const double length = distance(p, q);
    if (length == 0.0) return distance(p, m);
    return std::abs((q.x - p.x) * (m.z - p.z) - (q.z - p.z) * (m.x - p.x)) /
           length;
  };
  return std::max(at(0.0), at(depth));
}

/// Equal gaps of no more than kBetween from one length to another, `least` of
/// them or more: the places between, or with the ends.
std::vector<double> divided(double from, double to, int least, bool ends) {
  const int gaps =
      std::max(least, static_cast<int>(std::ceil((to - from) / kBetween)));
  std::vector<double> out;
  for (int i = ends ? 0 : 1; i <= (ends ? gaps : gaps - 1); ++i) {
    out.push_back(from + (to - from) * i / gaps);
  }
  return out;
}

/// \param first, last  whether it begins at A, ends at B
Piece piece_between(double from, double to, bool first, bool last,
                    const Build& build) {
  const Joint joint = joint_of(build);
  Piece piece{.from = from, .to = to};
  const double a = from + (first ? joint.near : joint.far);
  const double b = to - (last ? joint.near : joint.far);
  if (!first) piece.holes.push_back(from + joint.near);
  if (!last) piece.holes.push_back(to - joint.near);
  if (build.gauge) {
    piece.holes.insert(piece.holes.end(), {a, b});
    piece.slots = divided(a, b, 2, false);
  } else {
    std::ranges::copy(divided(a, b, 1, true), std::back_inserter(piece.holes));
  }
  std::ranges::sort(piece.holes);
  std::vector<double> all = piece.holes;
  all.insert(all.end(), piece.slots.begin(), piece.slots.end());
  std::ranges::sort(all);
  // With room for their rims.
  const double around = 0.75 * std::max(build.hole, build.thickness);
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (all[i] - all[i - 1] - 2.0 * around >
        piece.clear_to - piece.clear_from) {
      piece.clear_from = all[i - 1] + around;
      piece.clear_to = all[i] - around;
    }
  }
  return piece;
}

/// What the fasteners of a piece need.
double least_length(bool first, bool last, const Build& build) {
  const Joint joint = joint_of(build);
  const auto end = [&](bool free) { return free ? joint.near : joint.far; };
  const double slot = build.gauge ? build.thickness + 2.0 * build.hole : 0.0;
  return end(first) + end(last) + 3.0 * build.hole + slot;
}

}  // namespace

Point EdgePoint::at_depth(double depth) const {
  return beside(depth, 0.0);
}

Point EdgePoint::beside(double depth, double on) const {
  const double c = std::cos(beta), s = std::sin(beta);
  return {place.x - depth * s + on * c, place.z + depth * c + on * s};
}

Edge::Edge(const Motion& motion, const Build& build)
    : motion_(motion), per_metre_(build.per_metre()), strip_(build.strip) {
  // No feature is shorter than these.
  constexpr int kLeast = 100;
  const std::vector<TrajectoryPoint> rows = motion.fine_sample(kLeast);
  points_.push_back(edge_point(rows.front(), per_metre_));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    refine(edge_point(rows[i], per_metre_), 0);
  }
  for (std::size_t i = 1; i < points_.size(); ++i) {
    points_[i].along =
        points_[i - 1].along + distance(points_[i].place, points_[i - 1].place);
  }
}

/// Adds what leads from the last point to `next`.
void Edge::refine(const EdgePoint& next, int depth) {
  constexpr int kDeepest = 20;
  const EdgePoint last = points_.back();
  const EdgePoint middle =
      edge_point(motion_.at(0.5 * (last.sigma + next.sigma)), per_metre_);
  if (depth < kDeepest && sagitta(last, middle, next, strip_) > kChord) {
    refine(middle, depth + 1);
    refine(next, depth + 1);
  } else {
    points_.push_back(next);
  }
}

EdgePoint Edge::at(double along) const {
  const auto next =
      std::ranges::lower_bound(points_, along, {}, &EdgePoint::along);
  if (next == points_.begin()) return *next;
  if (next == points_.end()) return points_.back();
  const EdgePoint &a = *(next - 1), &b = *next;
  const double share = (along - a.along) / (b.along - a.along);
  const auto mean = [&](double p, double q) { return p + share * (q - p); };
  return {mean(a.sigma, b.sigma),
          {mean(a.place.x, b.place.x), mean(a.place.z, b.place.z)},
          mean(a.beta, b.beta),
          along};
}

double Edge::along(double sigma) const {
  const auto next =
      std::ranges::lower_bound(points_, sigma, {}, &EdgePoint::sigma);
  if (next == points_.begin()) return 0.0;
  if (next == points_.end()) return length();
  const EdgePoint &a = *(next - 1), &b = *next;
  return a.along +
         (b.along - a.along) * (sigma - a.sigma) / (b.sigma - a.sigma);
}

std::vector<EdgePoint> Edge::between(double from, double to) const {
  std::vector<EdgePoint> out{at(from)};
  for (const EdgePoint& p : points_) {
    if (p.along > from && p.along < to) out.push_back(p);
  }
  out.push_back(at(to));
  return out;
}

std::vector<Point> outline(const Edge& edge, double from, double to, double top,
                           double bottom) {
  const std::vector<EdgePoint> points = edge.between(from, to);
  std::vector<Point> out;
  for (const EdgePoint& p : points) out.push_back(p.at_depth(top));
  for (auto p = points.rbegin(); p != points.rend(); ++p) {
    out.push_back(p->at_depth(bottom));
  }
  return out;
}

Box box_of(const std::vector<Point>& points) {
  Box box{points.front(), points.front()};
  for (const Point p : points) box.include(p, 0.0);
  return box;
}

std::vector<double> turns_of(const Edge& edge, double from, double to) {
  const Point a = edge.at(from).place, b = edge.at(to).place;
  const double level = -std::atan2(b.z - a.z, b.x - a.x);
  return {0.0, level, level + 0.5 * std::numbers::pi};
}

Joint joint_of(const Build& build) {
  return {2.0 * build.hole, 5.0 * build.hole, 6.5 * build.hole};
}

double strip_width(const Build& build, double sharpest) {
  constexpr double kOfRadius = 0.8;
  const double hump = build.per_metre() / std::max(sharpest, 1e-9);
  const double width = std::min(build.strip, kOfRadius * hump);
  if (width < kStripInHoles * build.hole) {
    throw TemplateError(fmt::format(
        "a hump of the track has a radius of {:.3g} mm, and a strip below it "
        "less than {:.3g} mm of width, {:g} holes; a larger --scale, a smaller "
        "--hole, or scene.limits.curvature.hump makes room",
        hump, kStripInHoles * build.hole, kStripInHoles));
  }
  return width;
}

std::vector<Piece> pieces_of(const Edge& edge, const Build& build,
                             const std::function<bool(const Box&)>& fits) {
  const double length = edge.length();
  for (int count = 1;; ++count) {
    std::vector<Piece> pieces;
    for (int i = 0; i < count; ++i) {
      const double from = length * i / count, to = length * (i + 1) / count;
      const bool first = i == 0, last = i == count - 1;
      if (to - from < least_length(first, last, build)) {
        const std::string why =
            count == 1
                ? fmt::format("a track of {:.4g} mm is too short for its holes",
                              length)
                : fmt::format(
                      "{} pieces of {:.4g} mm are too short for the holes of "
                      "their joints, and longer ones do not fit on a sheet",
                      count, length / count);
        throw TemplateError(why +
                            "; a larger --sheet, a smaller --strip or --hole, "
                            "or another --scale makes room");
      }
      const std::vector<Point> corners =
          outline(edge, from, to, 0.0, edge.strip());
      const bool somehow =
          std::ranges::any_of(turns_of(edge, from, to), [&](double angle) {
            std::vector<Point> lying = corners;
            for (Point& p : lying) p = turned(p, angle);
            return fits(box_of(lying));
          });
      if (!somehow) break;
      pieces.push_back(piece_between(from, to, first, last, build));
    }
    if (pieces.size() == static_cast<std::size_t>(count)) return pieces;
  }
}

}  // namespace brachisto::report::cutting
