// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes in other worlds.

#pragma once

#include "support/scenes.hpp"

namespace brachisto::testing {

[[nodiscard]] inline Scene with_push(Scene scene, double speed) {
  scene.world.start_speed = speed;
  return scene;
}
[[nodiscard]] inline Scene in_air(Scene scene, double linear,
                                  double quadratic) {
  scene.world.air = {linear, quadratic};
  return scene;
}
/// With τ and forces in units of the strength at A.
[[nodiscard]] inline Scene about_sphere(Scene scene, const Sphere& sphere) {
  scene.world.sphere = sphere;
  scene.gravity = sphere.strength_at({0.0, 0.0});
  return scene;
}
/// A sphere so large that the scene is well inside, and so small that its field
/// turns by half a radian along the track.
[[nodiscard]] inline Sphere around() {
  return {{1.0, 5.0}, 8.0, 12.0};
}
/// The same from outside.
[[nodiscard]] inline Sphere below() {
  return {{1.0, 6.0}, 4.0, 20.0};
}
/// One whose surface the centre of mass passes on the way.
[[nodiscard]] inline Sphere in_the_way() {
  return {{1.0, 10.0}, 9.3, 9.81};
}

}  // namespace brachisto::testing
