// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Given curves: of a track, or of the path of a centre.

#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// A place on a curve that is run through as q goes from 0 to 1.
struct CurvePlace {
  Point offset;          ///< from the start of the curve, free of cancellation
  double beta = 0.0;     ///< slope angle, continuous along the curve [rad]
  double speed = 0.0;    ///< ds/dq ≥ 0 [m]
  double turning = 0.0;  ///< dβ/dq = κ ds/dq [rad]; finite even where the
                         ///< curvature κ is not
};

/// A curve without corners. Its parameter starts from rest, ds/dq ~ q at q = 0,
/// as the body does: then time is a smooth function of q.
class PlaneCurve {
 public:
  virtual ~PlaneCurve() = default;

  [[nodiscard]] virtual Point start() const = 0;
  [[nodiscard]] virtual CurvePlace at(double q) const = 0;
  /// Of a place the speed and the turning alone, which most curves have for far
  /// less.
  struct Pace {
    double speed = 0.0, turning = 0.0;
  };
  [[nodiscard]] virtual Pace pace(double q) const {
    const CurvePlace place = at(q);
    return {place.speed, place.turning};
  }
  /// Where the curvature has kinks; ascending, without the ends.
  [[nodiscard]] virtual std::vector<double> joints() const { return {}; }
};

/// Where a place lies.
[[nodiscard]] Point point_of(const PlaneCurve& curve, const CurvePlace& place);

using PlaneCurvePtr = std::shared_ptr<const PlaneCurve>;

/// The straight line.
[[nodiscard]] PlaneCurvePtr straight_line(Point start, Point end);

/// The parabola that leaves `start` with the given slope angle: with a vertical
/// one, π/2, its axis is horizontal, otherwise vertical.
/// \throws std::invalid_argument  if there is none, or it is no function of the
///         coordinate across its axis
[[nodiscard]] PlaneCurvePtr parabola(Point start, Point end,
                                     double start_angle);

/// The arc of a circle that leaves `start` with the given slope angle.
/// \throws std::invalid_argument  if `end` lies straight behind
[[nodiscard]] PlaneCurvePtr circular_arc(Point start, Point end,
                                         double start_angle);

/// The cycloid with a cusp at `start`.
/// \throws std::invalid_argument  unless `end` lies to the right and below
[[nodiscard]] PlaneCurvePtr cycloid_curve(Point start, Point end);

/// The cubic spline through points, by length of chords: twice continuously
/// differentiable, and of fourth order in the distance of points of a smooth
/// curve.
/// \throws std::invalid_argument  for fewer than two points, or equal
///         neighbours
[[nodiscard]] PlaneCurvePtr spline_through(const std::vector<Point>& points);

/// Vectors along a curve at its ends: their directions are the slopes there.
struct CurveEnds {
  Point at_start;               ///< offset/q² for q → 0
  std::optional<Point> at_end;  ///< d(offset)/dq at q = 1, if known
};

/// The curve through points that lie at the places q on a way from rest:
/// offset/q², which is smooth if the slope is a smooth function of q, and not
/// zero at the start, by cubic splines.
///
/// \param q        ascending from above 0 to 1; one or more
/// \param offsets  from the start, one for each q
[[nodiscard]] PlaneCurvePtr curve_from_rest(Point start, const CurveEnds& ends,
                                            const std::vector<double>& q,
                                            const std::vector<Point>& offsets);

/// The curve whose slope angle is a cubic spline, over s or √s, through those
/// given, or several where the curvature jumps.
[[nodiscard]] PlaneCurvePtr curve_of_slopes(Point start,
                                            const SlopesAlong& slopes);

/// The path of the centre of a body of radius r on a track; on a hump it is
/// longer, in a valley shorter. In a valley that is too narrow for the body
/// ds/dq < 0. Of the path of another centre in place of the track, r is what
/// the body's radius exceeds that of the other by.
[[nodiscard]] PlaneCurvePtr centre_path_over(PlaneCurvePtr track,
                                             double radius);

}  // namespace brachisto
