// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_frame.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "model/limit_table.hpp"

namespace brachisto::report {

namespace {

// Lengths on the picture [px].
constexpr double kLeastWidth = 400.0;
constexpr double kPlotHeight = 800.0, kLeastHeight = 150.0;
/// Bodies smaller than this are enlarged to that.
constexpr double kSmallRadius = 8.0, kEnlargedRadius = 45.0;

}  // namespace

Frame::Frame(const Box& content, double largest_scale) : box(content) {
  constexpr double kRoom = 1.06;
  const double wide = kRoom * content.width();
  const double high = kRoom * content.height();
  scale = std::min({kPictureWidth / wide, kPlotHeight / high, largest_scale});
  box = content.resized(std::max(wide, kLeastWidth / scale),
                        std::max(high, kLeastHeight / scale));
}

std::optional<Enlarged> enlarged(const Motion& motion,
                                 const std::vector<TrajectoryPoint>& rows,
                                 double scale) {
  const Body& body = motion.scene().body;
  if (!body.off_centred() || body.radius * scale >= kSmallRadius) return {};
  const double half = 0.5 * kPictureWidth * body.radius / kEnlargedRadius;
  const auto lowest = std::ranges::max_element(
      rows, {}, [](const TrajectoryPoint& p) { return p.centre.z; });
  const double middle =
      std::clamp(lowest->s, half, std::max(half, rows.back().s - half));
  const TrajectoryPoint& at =
      *std::ranges::lower_bound(rows, middle, {}, &TrajectoryPoint::s);
  // A little more than the frame shows.
  constexpr double kMore = 1.3;
  Box box{at.centre, at.centre};
  box.include(at.centre, body.outer_radius());
  std::vector<TrajectoryPoint> piece;
  for (const TrajectoryPoint& p : rows) {
    if (std::abs(p.s - middle) > kMore * half) continue;
    piece.push_back(p);
    if (std::abs(p.centre.x - at.centre.x) > half) continue;
    box.include(p.motion.contact, 0.0);
    box.include(p.centre, 0.0);
    box.include(p.motion.mass_centre, 0.0);
  }
  Frame frame(box, kEnlargedRadius / body.radius);
  frame.box =
      frame.box.resized(kPictureWidth / frame.scale, frame.box.height());
  return Enlarged{std::move(piece), at, frame};
}

namespace {

/// What of an area is behind a half-plane (Sutherland and Hodgman).
Outline behind(const HalfPlane& plane, const Outline& area) {
  const auto height = [&](Point p) {
    return (p.x - plane.point.x) * std::cos(plane.normal) +
           (p.z - plane.point.z) * std::sin(plane.normal);
  };
  Outline out;
  for (std::size_t i = 0; i < area.size(); ++i) {
    const Point from = area[i];
    const Point to = area[(i + 1) % area.size()];
    const double a = height(from);
    const double b = height(to);
    if (a <= 0.0) out.push_back(from);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
      const double part = a / (a - b);
      out.push_back(
          {from.x + part * (to.x - from.x), from.z + part * (to.z - from.z)});
    }
  }
  return out;
}

constexpr double kUp = -0.5 * std::numbers::pi;
constexpr double kDown = 0.5 * std::numbers::pi;
constexpr double kRight = 0.0;
constexpr double kLeft = std::numbers::pi;

}  // namespace

std::vector<Outline> obstacles(const PathLimits& limits, Point low,
                               Point high) {
  const Outline frame{low, {high.x, low.z}, high, {low.x, high.z}};
  std::vector<Outline> all;
  const auto add = [&](Outline area) {
    // Less is a point or a line on the frame.
    constexpr std::size_t kFewest = 3;
    if (area.size() >= kFewest) all.push_back(std::move(area));
  };
  for (const LimitEntry& limit : limit_table()) {
    const std::optional<double>& bound = limit.bound(limits);
    if (bound && limit.forbids) add(behind(limit.forbids(*bound), frame));
  }
  for (const HalfPlane& plane : limits.half_planes) add(behind(plane, frame));
  for (const Disc& disc : limits.discs) {
    constexpr int kCorners = 120;
    Outline area;
    for (int i = 0; i < kCorners; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kCorners;
      area.push_back({disc.centre.x + disc.radius * std::cos(angle),
                      disc.centre.z + disc.radius * std::sin(angle)});
    }
    for (const HalfPlane& side :
         {HalfPlane{low, kLeft}, HalfPlane{low, kUp}, HalfPlane{high, kRight},
          HalfPlane{high, kDown}}) {
      area = behind(side, area);
    }
    add(std::move(area));
  }
  return all;
}

}  // namespace brachisto::report
