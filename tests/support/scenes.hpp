// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes that tests have in common: H = 1, L = 3, r = 1/3.

#pragma once

#include "brachisto/model/scene.hpp"
#include "support/numbers.hpp"

namespace brachisto::testing {

[[nodiscard]] inline Scene scene_of(const Body& body) {
  Scene scene;
  scene.body = body;
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}
[[nodiscard]] inline Scene bead_scene() {
  return scene_of(Body::bead());
}
[[nodiscard]] inline Scene uniform_scene() {
  return scene_of(Body::cylinder(1.0 / 3.0, 0.0, 0.0, 0.5));
}
/// The base cylinder, η_m = 2/3 and k = 1/2.
[[nodiscard]] inline Scene off_centred_scene(double theta_m = 0.0) {
  return scene_of(Body::cylinder(1.0 / 3.0, 2.0 / 3.0, theta_m, 0.5));
}

/// The same scene in the unit of time for which 2 g = 1, as solvers like it.
[[nodiscard]] inline Scene natural(Scene scene) {
  scene.gravity = 0.5;
  return scene;
}

}  // namespace brachisto::testing
