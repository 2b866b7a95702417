// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The rolling body: a bead that slides, or a cylinder or ball that rolls
/// without slip and whose centre of mass may lie off its axis; and what it is
/// made of.

#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>

namespace brachisto {

/// A point of the plane, z down [m].
struct Point {
  double x = 0.0;
  double z = 0.0;

  friend bool operator==(const Point&, const Point&) = default;
};

/// [m]
[[nodiscard]] inline double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.z - b.z);
}

/// Shape of the body. A bead is a point mass that slides without friction.
enum class Shape { Bead, Cylinder, Ball };

/// A ball in its own numbers, and what it runs in: two rails, a groove, or a
/// plain track. It rolls like a cylinder, whose numbers Body has; section 17 of
/// docs/theory.md.
struct Ball {
  double radius = 0.0;  ///< R [m]
  double eta_m = 0.0;  ///< offset of the centre of mass in the middle plane, in
                       ///< R [-]
  double k = 0.0;      ///< I_cm / (m R²) [-]
  /// b [m]: between the edges of thin rails, or between the axes of round ones.
  std::optional<double> gauge = {};
  std::optional<double> rail_radius = {};  ///< ρ of round rails [m]; none: thin
  std::optional<double> groove = {};       ///< 2γ between the walls [rad]

  /// r_e [m], the distance of its axis from the line through its contacts:
  ///
  ///     √(R² − b²/4),  with round rails b R/(R + ρ) in place of b,
  ///     R sin γ in a groove;
  ///
  /// NaN where it falls between its rails.
  [[nodiscard]] double rolling_radius() const;
  /// Distance of its centre from what folds first where the path is a hump [m]:
  /// r_e, with round rails that of the plane of their axes, in a groove that of
  /// the bottom, R/sin γ.
  [[nodiscard]] double folding_distance() const;
};

/// Mass distribution of the body, section "Governing Equations" of the paper.
///
/// A bead has radius, offset and inertia zero, which turns every formula for a
/// cylinder into the formula for the bead. A ball has the numbers of the
/// cylinder that rolls alike: r_e, η_e = η_m R/r_e and k_e = k (R/r_e)², which
/// may be above 1.
struct Body {
  Shape shape = Shape::Cylinder;
  double radius = 0.0;   ///< r [m]
  double eta_m = 0.0;    ///< η_m = r_m / r, offset of the centre of mass [-]
  double theta_m = 0.0;  ///< θ_m, its angle at the start, from +x towards +z
                         ///< (downwards) [rad]
  double k = 0.0;        ///< I_cm / (m r²) [-]
  std::optional<double> mass = {};  ///< m [kg]; only turns forces into newtons
  /// R/r_e of a ball: how far it reaches beyond what it rolls on, and how much
  /// more than R_n the walls press, in sum.
  double wall_ratio = 1.0;
  double fold_ratio = 1.0;        ///< of a ball, folding_distance()/r_e
  std::optional<Ball> ball = {};  ///< in its own numbers

  [[nodiscard]] static Body bead() { return {.shape = Shape::Bead}; }
  [[nodiscard]] static Body cylinder(double radius, double eta_m,
                                     double theta_m, double k) {
    return {.radius = radius, .eta_m = eta_m, .theta_m = theta_m, .k = k};
  }
  [[nodiscard]] static Body rolling_ball(const Ball& ball, double theta_m);

  /// True if the body turns as it moves, so that θ has a meaning.
  [[nodiscard]] bool rolls() const { return shape != Shape::Bead; }
  /// True if the motion depends on θ; otherwise A is constant and θ drops out.
  [[nodiscard]] bool off_centred() const { return rolls() && eta_m != 0.0; }
  /// Of what floor and obstacles see [m].
  [[nodiscard]] double outer_radius() const { return radius * wall_ratio; }
  /// Of what folds first, seen from the centre [m].
  [[nodiscard]] double folding_distance() const { return radius * fold_ratio; }
};

/// The body with r, η_m and k in its own numbers: those of a ball in place of
/// those that it rolls with.
[[nodiscard]] Body as_stated(Body body);

/// The other way round: a ball from r, η_m and k in its own numbers, and from
/// what it runs in.
[[nodiscard]] Body as_it_rolls(const Body& stated);

/// A piece of a body in the plane of its motion, places as seen from the axis
/// of the cylinder, in any unit of length and any unit of mass.
///
/// The functions that make one throw std::invalid_argument unless masses and
/// radii are positive and all numbers finite.
struct MassPart {
  double mass = 0.0;
  Point centre;              ///< its centre of mass
  double own_inertia = 0.0;  ///< about that, over its mass [length²]
  double reach = 0.0;        ///< of the point farthest from the axis
  std::string name = {};     ///< how messages call it

  /// How far it extends from its own centre, if it is a point, ring or disc.
  [[nodiscard]] double extent() const {
    return reach - std::hypot(centre.x, centre.z);
  }

  [[nodiscard]] static MassPart point(double mass, Point at);
  /// A thin ring, I = m a².
  [[nodiscard]] static MassPart ring(double mass, Point at, double radius);
  /// A uniform disc, or an annulus about a hole of smaller radius b,
  /// I = m (a² + b²)/2.
  [[nodiscard]] static MassPart disc(double mass, Point at, double radius,
                                     double hole = 0.0);
  /// A thin uniform rod, I = m l²/12.
  [[nodiscard]] static MassPart rod(double mass, Point from, Point to);
};

/// 1 − η_m², the largest k that a body with this offset can have: that of one
/// whose mass all sits on the rim. Of a ball in its own numbers it is the same,
/// the rim being the great circle in the middle plane.
[[nodiscard]] inline double largest_k(double eta_m) {
  return (1.0 - eta_m) * (1.0 + eta_m);
}

/// What the motion of a body depends on, in the symbols of Body.
struct MassProperties {
  double mass = 0.0;
  double r_m = 0.0;      ///< offset of the centre of mass [unit of length]
  double eta_m = 0.0;    ///< r_m / r
  double theta_m = 0.0;  ///< from +x towards +z (down) [rad]; 0 if η_m = 0
  double k = 0.0;        ///< I_cm / (m r²)

  [[nodiscard]] double largest_k() const { return brachisto::largest_k(eta_m); }
};

/// Properties of a cylinder that consists of these parts.
///
/// I_cm = Σ m_i (j_i + |x_i − x_cm|²) by the parallel axes, j_i the own
/// inertias: a sum of positive terms, in a second pass over the parts. An
/// offset that rounding of the places alone could make counts as none.
///
/// \param radius  r, in the unit of length of the parts
/// \throws std::invalid_argument  if there are no parts, if r is not positive,
///         or if a part does not lie within the cylinder; it names the part
[[nodiscard]] MassProperties mass_properties(std::span<const MassPart> parts,
                                             double radius);

}  // namespace brachisto
