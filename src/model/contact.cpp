// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "model/contact.hpp"

#include <cmath>

#include "brachisto/math/jet.hpp"
#include "model/field.hpp"
#include "model/start_angle.hpp"

namespace brachisto {

Point centre_above(Point contact, double radius, double beta) {
  return {contact.x + radius * std::sin(beta),
          contact.z - radius * std::cos(beta)};
}

Point track_below(Point centre, double radius, double beta) {
  return {centre.x - radius * std::sin(beta),
          centre.z + radius * std::cos(beta)};
}

Point start_of_centre(const Scene& scene) {
  if (scene.contact == Contact::Centre) return {0.0, 0.0};
  return centre_above({0.0, 0.0}, scene.body.radius, start_angle(scene));
}

StartRates start_rates(const Scene& scene) {
  const double alpha = start_angle(scene);
  const double r = contact_radius(scene);
  using On = math::Jet1<double, 1>;
  return {r * std::cos(alpha), r * std::sin(alpha),
          pushed_w(scene, On::variable(alpha, 0)).gradient[0]};
}

Point end_of_centre(const Scene& scene, double phi) {
  if (scene.contact == Contact::Centre) return {scene.L, scene.H};
  return centre_above({scene.L, scene.H}, scene.body.radius, phi);
}

}  // namespace brachisto
