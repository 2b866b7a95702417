// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The formulas of each field that may stand in place of the uniform one, for
/// numbers, jets and formulas of files. model/field.hpp asks for them:
///
///     pull             its force per mass at a place, or so much of it
///     strength         the same without its direction [m/s²]
///     potential_fall   by how much its potential falls from place to place
///     highest, lowest  places of the most and the least potential near one
///
/// and of a field that has one for
///
///     height           how far a place is beyond the surface where the field
///                      has a kink
///     turning_centre   the place about which all may be turned

#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include "brachisto/model/world.hpp"
#include "math/constant_of.hpp"

namespace brachisto {

/// A place or a direction.
template <class Scalar>
struct InPlane {
  Scalar x, z;
};
/// A force per mass.
template <class Scalar>
using Pull = InPlane<Scalar>;

/// The number in a jet.
template <class Scalar>
[[nodiscard]] double plain(const Scalar& number) {
  if constexpr (requires { number.value; }) {
    return plain(number.value);
  } else {
    return static_cast<double>(number);
  }
}

/// above() where a number lies above a bound, otherwise below(): decided by its
/// value, or by whatever stands for it.
template <class Scalar, class Above, class Below>
[[nodiscard]] Scalar where_above(const Scalar& number, double bound,
                                 const Above& above, const Below& below) {
  return plain(number) > bound ? above() : below();
}

namespace fields {

/// Towards the centre of a sphere of radius R with the surface gravity g_s, at
/// the distance d,
///
///     g_s d/R inside,  g_s (R/d)² outside.
///
/// \tparam AnySphere  Sphere, or the numbers of several side by side
/// \tparam Share      double, or those of several
/// \tparam Side       FieldSide, or std::optional of it: nothing: that of the
///                    place
template <class AnySphere, class Share, class Side, class Scalar>
[[nodiscard]] Pull<Scalar> pull(const AnySphere& sphere, const Share& share,
                                const Side& side, const Scalar& x,
                                const Scalar& z) {
  using std::sqrt;
  using Constant = math::ConstantOf<Scalar>;
  const Constant R(sphere.radius);
  const Scalar dx = x - Scalar(sphere.centre.x);
  const Scalar dz = z - Scalar(sphere.centre.z);
  const Scalar square = dx * dx + dz * dz;
  const Constant at_surface = Constant(share) * sphere.surface_gravity / R;
  const auto inside = [&] { return Scalar(-at_surface); };
  const auto outside = [&]() -> Scalar {
    return Scalar(-at_surface * R * R * R) / (square * sqrt(square));
  };
  const auto by_law = [&](FieldSide law) {
    return law == FieldSide::Outside ? outside() : inside();
  };
  const Scalar per_length = [&] {
    if constexpr (std::is_same_v<Side, FieldSide>) {
      return by_law(side);
    } else {
      return side ? by_law(*side)
                  : where_above(square, sphere.radius * sphere.radius, outside,
                                inside);
    }
  }();
  return {dx * per_length, dz * per_length};
}

[[nodiscard]] inline double strength(const Sphere& sphere, Point place) {
  return sphere.strength_at(place);
}

/// Of the potential
///
///     Φ = g_s (d² − 3 R²)/(2 R) inside,  −g_s R²/d outside.
///
/// \param by  to − from
[[nodiscard]] inline double potential_fall(const Sphere& sphere, Point from,
                                           Point to, Point by) {
  const auto& [centre, R, g_s] = sphere;
  const double d_0 = distance(from, centre);
  const double d_1 = distance(to, centre);
  // d₀² − d₁²
  const double squares = -by.x * (from.x + to.x - 2.0 * centre.x) -
                         by.z * (from.z + to.z - 2.0 * centre.z);
  if (d_0 > R && d_1 > R) {
    return g_s * R * (R / d_0) * (squares / (d_0 + d_1)) / d_1;
  }
  // What the law of the inside is above that of the outside.
  const auto excess = [g = g_s, R = R](double d) {
    return d > R ? g * (d - R) * (d - R) * (d + 2.0 * R) / (2.0 * R * d) : 0.0;
  };
  return 0.5 * g_s * squares / R + (excess(d_1) - excess(d_0));
}

/// The potential grows with the distance from the centre.
[[nodiscard]] inline Point highest(const Sphere& sphere, Point place,
                                   double by) {
  const Point& O = sphere.centre;
  const double d = distance(place, O);
  if (d == 0.0) return {place.x + by, place.z};
  return {place.x + by * (place.x - O.x) / d,
          place.z + by * (place.z - O.z) / d};
}
/// Of all that are from `nearest` to `furthest` away.
[[nodiscard]] inline Point lowest(const Sphere& sphere, Point place,
                                  double nearest, double furthest) {
  const Point& O = sphere.centre;
  const double d = distance(place, O);
  return d >= furthest ? highest(sphere, place, -furthest)
         : d < nearest ? highest(sphere, place, -nearest)
                       : O;
}

/// d − R.
template <class Scalar>
[[nodiscard]] Scalar height(const Sphere& sphere, const Scalar& x,
                            const Scalar& z) {
  using std::sqrt;
  const Scalar dx = x - Scalar(sphere.centre.x);
  const Scalar dz = z - Scalar(sphere.centre.z);
  return sqrt(dx * dx + dz * dz) - Scalar(sphere.radius);
}

[[nodiscard]] inline Point turning_centre(const Sphere& sphere) {
  return sphere.centre;
}

}  // namespace fields

}  // namespace brachisto
