// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a picture of a path shows of the plane, in what scale, and where limits
/// do not let the body be.

#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/trajectory/motion.hpp"

namespace brachisto::report {

inline constexpr double kPictureWidth = 860.0;  ///< at most [px]

/// Axis-aligned, in metres.
struct Box {
  Point low, high;

  void include(Point p, double radius) {
    low = {std::min(low.x, p.x - radius), std::min(low.z, p.z - radius)};
    high = {std::max(high.x, p.x + radius), std::max(high.z, p.z + radius)};
  }
  /// The same middle, with that width and height.
  [[nodiscard]] Box resized(double width, double height) const {
    const Point middle{0.5 * (low.x + high.x), 0.5 * (low.z + high.z)};
    return {{middle.x - 0.5 * width, middle.z - 0.5 * height},
            {middle.x + 0.5 * width, middle.z + 0.5 * height}};
  }
  [[nodiscard]] double width() const { return high.x - low.x; }
  [[nodiscard]] double height() const { return high.z - low.z; }
};

/// A box with room at the frame, and its size on the picture, of equal scales.
struct Frame {
  Box box;
  double scale;  ///< [px/m]

  Frame(const Box& content, double largest_scale);
  [[nodiscard]] double width() const { return scale * box.width(); }
  [[nodiscard]] double height() const { return scale * box.height(); }
};

/// The piece of the track about its lowest place that is shown enlarged.
struct Enlarged {
  std::vector<TrajectoryPoint> rows;
  TrajectoryPoint body;
  Frame frame;
};

/// Of a body so small on a picture of that scale [px/m] that its bumps would
/// vanish; nothing otherwise.
[[nodiscard]] std::optional<Enlarged> enlarged(
    const Motion& motion, const std::vector<TrajectoryPoint>& rows,
    double scale);

/// Corners of a convex area, in order.
using Outline = std::vector<Point>;

/// What lies below the floor, in a disc and behind a half-plane, as far as it
/// lies between two opposite corners of a frame [m]; nothing of what does not.
[[nodiscard]] std::vector<Outline> obstacles(const PathLimits& limits,
                                             Point low, Point high);

}  // namespace brachisto::report
