// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/field.hpp"

#include "model/energy.hpp"

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

double work_of_field(const Scene& scene, Point start, Point offset,
                     double turned) {
  const Body& body = scene.body;
  // The way of the centre of mass, r η (cos θ − cos θ_m) as a product.
  const double half = 0.5 * turned;
  const Point by{offset.x - 2.0 * body.radius * body.eta_m * std::sin(half) *
                                std::sin(half + body.theta_m),
                 energy_height_after(body, offset.z, turned)};
  const Point from = mass_centre(body, start, body.theta_m);
  return potential_fall(scene, from, {from.x + by.x, from.z + by.z}, by);
}

}  // namespace brachisto
