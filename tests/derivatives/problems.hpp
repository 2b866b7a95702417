// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// One factory of problems for all tests of derivatives.

#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string>
#include <vector>

#include "support/scenes.hpp"
#include "support/world_scenes.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::testing {

/// A problem to differentiate.
struct ProblemCase {
  std::string name;
  Scene scene;
  Mesh mesh;

  [[nodiscard]] RollingTime problem() const { return {scene, mesh, -0.2}; }
};

inline std::ostream& operator<<(std::ostream& out, const ProblemCase& row) {
  return out << row.name;
}

/// Elements that grow like those of a mesh refined towards the start.
[[nodiscard]] inline Mesh graded_mesh(int degree, int num_elements) {
  Mesh mesh = uniform_mesh(degree, num_elements);
  for (double& boundary : mesh.boundaries) boundary *= boundary;
  return mesh;
}

/// Bead, uniform and off-centred cylinders, one of them almost without inertia,
/// with all degrees up to `largest_degree` on uniform and graded meshes.
[[nodiscard]] inline std::vector<ProblemCase> problem_cases(int largest_degree,
                                                            int num_elements) {
  const std::pair<const char*, Body> bodies[] = {
      {"Bead", Body::bead()},
      {"Uniform", Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5)},
      {"OffCentred", Body::cylinder(1.0 / 3.0, 2.0 / 3.0, -kPi / 6.0, 0.5)},
      {"NearlyPointMass", Body::cylinder(0.4, 0.9, 0.7, 0.05)},
  };
  std::vector<ProblemCase> cases;
  for (const auto& [name, body] : bodies) {
    for (int p = 1; p <= largest_degree; ++p) {
      Scene scene = scene_of(body);
      scene.gravity = 0.5;
      cases.push_back({fmt::format("{}Degree{}Uniform", name, p), scene,
                       uniform_mesh(p, num_elements)});
      cases.push_back({fmt::format("{}Degree{}Graded", name, p), scene,
                       graded_mesh(p, num_elements)});
    }
  }
  // Other worlds.
  const std::pair<const char*, Scene> worlds[] = {
      {"PushedInAir",
       natural(
           in_air(with_push(off_centred_scene(-kPi / 6.0), 1.0), 0.3, 0.2))},
      {"InASphere", natural(about_sphere(off_centred_scene(0.4), around()))},
      {"BeadInAirAboveASphere",
       natural(in_air(about_sphere(bead_scene(), below()), 0.3, 0.2))},
  };
  for (const auto& [name, scene] : worlds) {
    for (int p = 1; p <= largest_degree; ++p) {
      cases.push_back({fmt::format("{}Degree{}", name, p), scene,
                       uniform_mesh(p, num_elements)});
    }
  }
  return cases;
}

}  // namespace brachisto::testing
