// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scene: a body, the point it has to reach, gravity, what "start" and
/// "finish" mean, and what a track that can be built and rolled has to keep to.

#pragma once

#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "brachisto/model/world.hpp"

namespace brachisto {

/// How sharply a path may turn, both bounds positive [1/m].
struct CurvatureLimit {
  enum class Of { Track, Centre };

  std::optional<double> hump;    ///< downwards: κ ≤ hump
  std::optional<double> valley;  ///< upwards: κ ≥ −valley
  Of of = Of::Track;
};

/// A disc that the body must not touch.
struct Disc {
  Point centre;         ///< [m]
  double radius = 0.0;  ///< [m]
};

/// All that lies behind the line through a point, which the body must not
/// touch: the normal points to where it may be.
struct HalfPlane {
  Point point;          ///< [m]
  double normal = 0.0;  ///< angle from +x towards +z [rad]
};

/// Limits on request. None of them is there unless it is asked for.
struct PathLimits {
  std::optional<double> friction;    ///< |R_t| ≤ μ R_n
  std::optional<double> normal_min;  ///< R_n ≥ this [m g]
  std::optional<double> normal_max;  ///< R_n ≤ this [m g]
  CurvatureLimit curvature;
  std::optional<double> fold_margin;  ///< 1 − r κ_c ≥ this, in [0, 1)
  std::optional<double> floor;        ///< no part of the body below z = D [m]
  std::vector<Disc> discs;
  std::vector<HalfPlane> half_planes;

  [[nodiscard]] bool any() const {
    return friction || normal_min || normal_max || curvature.hump ||
           curvature.valley || fold_margin || floor || !discs.empty() ||
           !half_planes.empty();
  }
};

/// How far the points of a path may miss A and B: so much of L in x and of H in
/// z.
inline constexpr double kCloseToEnds = 1e-6;

struct Scene;

/// The slopes along a curve.
struct SlopesAlong {
  double length = 0.0;  ///< S [m]
  /// √(s/S), ascending from 0 to 1; two or more, and twice between the ends
  /// where the curvature jumps.
  std::vector<double> q;
  std::vector<double> beta;  ///< one for each q [rad]
  /// β is a smooth function of s, and its curvature at the start finite;
  /// otherwise one of √s alone.
  bool smooth_over_length = false;
};

/// A path that is evaluated, not optimised.
struct GivenPath {
  /// Whose curve it is.
  enum class Curve {
    Centre,  ///< of the path of the centre
    Track,   ///< of the track, from A to B
  };
  enum class Shape {
    Straight,
    Parabola,
    CircularArc,
    Cycloid,
    Points,
    Slopes,  ///< of the curve from its start on; not in files
  };

  Curve curve = Curve::Centre;
  Shape shape = Shape::Straight;
  /// Slope angle at the start, of a parabola or an arc [rad].
  std::optional<double> start_angle;
  std::vector<Point> points;  ///< of Shape::Points [m]
  SlopesAlong slopes;         ///< of Shape::Slopes
  /// On whose track, if it is another body's: that scene states the path of its
  /// own centre, perhaps at another radius. What else is stated here only shows
  /// the track, as files have to.
  std::shared_ptr<const Scene> track_of;

  /// True if the shape leaves the choice of the start angle.
  [[nodiscard]] bool has_start_angle() const {
    return shape == Shape::Parabola || shape == Shape::CircularArc;
  }
  /// The given one, or vertical.
  [[nodiscard]] double start_angle_or_vertical() const {
    return start_angle.value_or(0.5 * std::numbers::pi);
  }
};

/// What the points A = (0, 0) and B = (L, H) are points of.
enum class Contact {
  Smooth,    ///< of the track: the body touches it at A and at B
  Centre,    ///< of the path of the centre, which starts at A and ends at B
  Optimal,   ///< of the track, whose slopes at A and B are free and optimal
  EndSlope,  ///< of the track, whose slope at B is given
};

/// Everything that determines the track. z points down.
struct Scene {
  Body body;
  double L = 0.0;  ///< horizontal distance from A to B [m]
  double H = 0.0;  ///< drop from A to B [m]
  /// g [m/s²], of the uniform field. In that of a sphere it is what τ and
  /// forces in m g refer to: the strength at A.
  double gravity = 9.81;
  World world;
  Contact contact = Contact::Smooth;
  std::optional<double> end_slope;  ///< of Contact::EndSlope [rad]
  PathLimits limits;                ///< what the motion has to keep to
  /// To be evaluated; none: the extremal is sought.
  std::shared_ptr<const GivenPath> path;
};

/// The same scene with θ_m within a turn: whole turns only cost digits.
[[nodiscard]] Scene without_whole_turns(const Scene& scene);

/// The same with what it implies: a bead with friction keeps R_n ≥ 0, unless it
/// is on a given path.
[[nodiscard]] Scene with_implied_limits(Scene scene);

/// One reason why a scene is refused.
struct SceneError {
  std::string key;      ///< dotted key of the problem file, "scene.body.k"
  std::string message;  ///< the value, the bound and why the bound holds
};

/// Slack allowed to bounds that a user can only state rounded, such as
/// k = 1 − η² with η = 1/√2: a few ulps of numbers of order one.
inline constexpr double kBoundSlack = 1e-14;

/// What lengths, gravity, mass and an offset that is not zero may be, in SI
/// units: products of six such numbers, more than any formula here has, stay
/// between 1e-300 and 1e300, and so normal numbers of 64 bits.
inline constexpr double kSmallestQuantity = 1e-50;
inline constexpr double kLargestQuantity = 1e50;

/// Of θ_m and other angles, either sign [rad]. Whole turns mean nothing, and
/// beyond this the rounding of the number alone, half an ulp or 6e-11 rad, is
/// more than the relative error that a solve is asked for by default.
inline constexpr double kLargestAngle = 1e6;

/// Checks a scene against the bounds that physics puts on it, and those that
/// numbers of 64 bits put on any.
///
///   r > 0, 0 ≤ η_m < 1, 0 ≤ k ≤ 1 − η_m² (with kBoundSlack), L > 0, H > 0,
///   g > 0, mass > 0 if given, each of them but k in [kSmallestQuantity,
///   kLargestQuantity] unless zero, angles up to kLargestAngle, a bead without
///   any other key; of a ball these hold of its own numbers, and it does not
///   fall between its rails or dip with its centre of mass below its contacts.
///   η_m = 1 (which leaves k = 0) is refused because A = 1 + η_m² + k − 2 η_m
///   sin(θ − β) then vanishes whenever the mass point touches the track.
///
/// \return all violations, empty if the scene is well formed. A well-formed
///         scene may still have no admissible path, or none that is found; see
///         Status::NoAdmissiblePath and Status::NotReached.
[[nodiscard]] std::vector<SceneError> validate(const Scene& scene);

}  // namespace brachisto
