// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// arc_length problems to differentiate, and points where they are defined.

#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "support/random_points.hpp"
#include "support/scenes.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto::testing {

/// A scene and its name.
struct ArcLengthCase {
  std::string name;
  Scene scene;
};

inline std::ostream& operator<<(std::ostream& out, const ArcLengthCase& row) {
  return out << row.name;
}

/// Bead, uniform and off-centred cylinders, one of them almost without inertia.
[[nodiscard]] inline std::vector<ArcLengthCase> arc_length_cases() {
  return {{"Bead", natural(bead_scene())},
          {"Uniform", natural(uniform_scene())},
          {"OffCentred", natural(off_centred_scene(-kPi / 6.0))},
          {"NearlyPointMass",
           natural(scene_of(Body::cylinder(0.4, 0.9, 0.7, 0.05)))}};
}

/// A steep polygon whose lengths and rotations grow like σ² and agree but for
/// a twentieth: with sin β > 0.93 > η, E grows along all of it, and chords no
/// longer than r Δθ leave A positive.
[[nodiscard]] inline std::vector<double> random_point(const ArcLength& problem,
                                                      Random& random) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  using enum StateComponent;
  const VariableLayout& layout = problem.layout();
  std::vector<double> x(at(layout.num_variables()));
  double x_c = 0.0, z_c = 0.0, turned = 0.0;
  for (int node = 1; node <= layout.num_points(); ++node) {
    const double length = 3.0 * problem.share(node) * random.uniform(0.9, 1.1);
    const double chord = length * random.uniform(0.95, 1.0);
    const double beta = random.uniform(1.2, 1.9);
    x[at(layout.state(node, X))] = x_c += chord * std::cos(beta);
    x[at(layout.state(node, Z))] = z_c += chord * std::sin(beta);
    if (!layout.has_theta()) continue;
    x[at(layout.state(node, Theta))] = turned +=
        length / problem.scene().body.radius;
  }
  x.back() = random.uniform(2.0, 4.0);
  return x;
}

}  // namespace brachisto::testing
