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

double potential_at(const Scene& scene, Point place) {
  const World& world = scene.world;
  if (!world.sphere) return -scene.gravity * place.z;
  const auto& [centre, R, g_s] = *world.sphere;
  const double d = std::hypot(place.x - centre.x, place.z - centre.z);
  const double of_sphere =
      d > R ? -g_s * R * R / d : 0.5 * g_s * (d * d / R - 3.0 * R);
  return std::lerp(-scene.gravity * place.z, of_sphere, world.sphere_share);
}

double potential_fall(const Scene& scene, Point from, Point to) {
  const World& world = scene.world;
  const double uniform = scene.gravity * (to.z - from.z);
  if (!world.sphere) return uniform;
  const auto& [centre, R, g_s] = *world.sphere;
  const double d_0 = std::hypot(from.x - centre.x, from.z - centre.z);
  const double d_1 = std::hypot(to.x - centre.x, to.z - centre.z);
  if ((d_0 > R) != (d_1 > R)) {
    return potential_at(scene, from) - potential_at(scene, to);
  }
  // d₀² − d₁²
  const double squares = (from.x - to.x) * (from.x + to.x - 2.0 * centre.x) +
                         (from.z - to.z) * (from.z + to.z - 2.0 * centre.z);
  const double of_sphere =
      d_0 > R ? g_s * R * (R / d_0) * (squares / (d_0 + d_1)) / d_1
              : 0.5 * g_s * squares / R;
  return std::lerp(uniform, of_sphere, world.sphere_share);
}

}  // namespace brachisto
