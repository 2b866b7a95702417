// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A track in pieces: where it is cut across, and where fasteners go.

#pragma once

#include <functional>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "report/cutting_build.hpp"
#include "report/path_frame.hpp"

namespace brachisto::report::cutting {

/// A place of the track as it is built [mm].
struct EdgePoint {
  double sigma = 0.0;
  Point place;         ///< from A, z down
  double beta = 0.0;   ///< slope [rad]
  double along = 0.0;  ///< length of the track from A

  /// So far below the track, along its normal.
  [[nodiscard]] Point at_depth(double depth) const;
  /// The same, so far on along its tangent.
  [[nodiscard]] Point beside(double depth, double on) const;
};

/// The track as chords that stay within 0.005 mm of it, and of its parallel at
/// the other side of a strip.
class Edge {
 public:
  /// \param build  its strip as wide as strip_width()
  Edge(const Motion& motion, const Build& build);

  [[nodiscard]] double strip() const { return strip_; }
  [[nodiscard]] double length() const { return points_.back().along; }
  [[nodiscard]] EdgePoint at(double along) const;
  /// The length at a place of the motion.
  [[nodiscard]] double along(double sigma) const;
  /// Its points between two lengths, with both ends.
  [[nodiscard]] std::vector<EdgePoint> between(double from, double to) const;

 private:
  void refine(const EdgePoint& next, int depth);

  const Motion& motion_;
  double per_metre_, strip_;
  std::vector<EdgePoint> points_;
};

/// One piece of a strip.
struct Piece {
  double from = 0.0, to = 0.0;              ///< lengths from A [mm]
  std::vector<double> holes = {};           ///< lengths where there is one
  std::vector<double> slots = {};           ///< likewise, for spacers
  double clear_from = 0.0, clear_to = 0.0;  ///< the longest of neither
};

/// The corners of what lies between two lengths and two depths.
[[nodiscard]] std::vector<Point> outline(const Edge& edge, double from,
                                         double to, double top, double bottom);

[[nodiscard]] Box box_of(const std::vector<Point>& points);

/// How what lies between two lengths may be turned on a sheet [rad]: as it
/// hangs, with its ends level, with its ends plumb.
[[nodiscard]] std::vector<double> turns_of(const Edge& edge, double from,
                                           double to);

/// From a joint to the holes beside it, and to the end of the plate that laps
/// it [mm].
struct Joint {
  double near, far, end;
};
[[nodiscard]] Joint joint_of(const Build& build);

/// How wide the strips are: as asked for, or less where a hump of the track is
/// so sharp that a strip would fold on its other side.
/// \param sharpest  hump of the track [1/m]
/// \throws TemplateError
[[nodiscard]] double strip_width(const Build& build, double sharpest);

/// As few pieces as fit, turned if need be, all of the same length, cut across
/// the track.
/// \param fits  whether there is room for a box
/// \throws TemplateError
[[nodiscard]] std::vector<Piece> pieces_of(
    const Edge& edge, const Build& build,
    const std::function<bool(const Box&)>& fits);

}  // namespace brachisto::report::cutting
