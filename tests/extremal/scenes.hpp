// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes that the tests of the indirect method share.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto::testing {

/// A scene with H = 1 and smooth contact.
inline Scene scene_of(const Body& body, double L) {
  Scene scene;
  scene.body = body;
  scene.L = L;
  scene.H = 1.0;
  return scene;
}

/// The base case: L = 3, r = 1/3, η = 2/3, k = 1/2.
inline Scene base_scene(double theta_m = 0.0) {
  return scene_of(Body::cylinder(1.0 / 3.0, 2.0 / 3.0, theta_m, 0.5), 3.0);
}

}  // namespace brachisto::testing
