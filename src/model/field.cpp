// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/field.hpp"

namespace brachisto {

double Sphere::strength_at(Point place) const {
  const double d = distance(place, centre);
  return d > radius ? surface_gravity * (radius / d) * (radius / d)
                    : surface_gravity * d / radius;
}

FieldSide side_of_surface(const Scene& scene, Point place) {
  return height_above_surface(scene, place) > 0.0 ? FieldSide::Outside
                                                  : FieldSide::Inside;
}

double potential_fall(const Scene& scene, Point from, Point to, Point by) {
  const World& world = scene.world;
  const double uniform = scene.gravity * by.z;
  return world.by_field(
      [&] { return uniform; },
      [&](const auto& field) {
        return std::lerp(uniform, fields::potential_fall(field, from, to, by),
                         world.field_share);
      });
}

}  // namespace brachisto
