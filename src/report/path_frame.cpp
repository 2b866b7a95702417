// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/path_frame.hpp"

#include <cmath>
#include <utility>

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
  box.include(at.centre, body.radius);
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

}  // namespace brachisto::report
