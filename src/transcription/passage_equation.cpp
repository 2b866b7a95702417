// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "transcription/passage_equation.hpp"

#include <cmath>

#include "brachisto/math/index.hpp"
#include "model/field.hpp"

namespace brachisto {

nlp::TangencyCondition::Linearisation height_at_beginning(
    const RollingTime& problem, int element, std::span<const double> x) {
  using enum StateComponent;
  const Scene& scene = problem.scene();
  const VariableLayout& layout = problem.layout();
  const int node = element * problem.mesh().degree;
  const int place_x = layout.state(node, X);
  const int place_z = layout.state(node, Z);
  const double theta =
      layout.has_theta() ? x[at(layout.state(node, Theta))] : 0.0;
  const Point heavy =
      mass_centre(scene.body, {x[at(place_x)], x[at(place_z)]}, theta);
  const Point centre = scene.world.sphere->centre;
  const double distance = std::hypot(heavy.x - centre.x, heavy.z - centre.z);
  const Point n{(heavy.x - centre.x) / distance,
                (heavy.z - centre.z) / distance};
  nlp::TangencyCondition::Linearisation out;
  out.residual = height_above_surface(scene, heavy);
  out.by_x = {{place_x, place_z}, {n.x, n.z}};
  if (layout.has_theta()) {
    out.by_x.index.push_back(layout.state(node, Theta));
    out.by_x.value.push_back(scene.body.radius * scene.body.eta_m *
                             (n.z * std::cos(theta) - n.x * std::sin(theta)));
  }
  return out;
}

}  // namespace brachisto
