// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/field.hpp"

namespace brachisto {

double Sphere::strength_at(Point place) const {
  const double d = std::hypot(place.x - centre.x, place.z - centre.z);
  return d > radius ? surface_gravity * (radius / d) * (radius / d)
                    : surface_gravity * d / radius;
}

SphereSide side_of_surface(const Scene& scene, Point place) {
  return height_above_surface(scene, place) > 0.0 ? SphereSide::Outside
                                                  : SphereSide::Inside;
}

double potential_fall(const Scene& scene, Point from, Point to, Point by) {
  const World& world = scene.world;
  const double uniform = scene.gravity * by.z;
  if (!world.sphere) return uniform;
  const auto& [centre, R, g_s] = *world.sphere;
  const double d_0 = std::hypot(from.x - centre.x, from.z - centre.z);
  const double d_1 = std::hypot(to.x - centre.x, to.z - centre.z);
  // d₀² − d₁²
  const double squares = -by.x * (from.x + to.x - 2.0 * centre.x) -
                         by.z * (from.z + to.z - 2.0 * centre.z);
  double of_sphere = 0.5 * g_s * squares / R;
  if (d_0 > R && d_1 > R) {
    of_sphere = g_s * R * (R / d_0) * (squares / (d_0 + d_1)) / d_1;
  } else {
    // What the law of the inside is above that of the outside.
    const auto excess = [g = g_s, R = R](double d) {
      return d > R ? g * (d - R) * (d - R) * (d + 2.0 * R) / (2.0 * R * d)
                   : 0.0;
    };
    of_sphere += excess(d_1) - excess(d_0);
  }
  return std::lerp(uniform, of_sphere, world.sphere_share);
}

}  // namespace brachisto
