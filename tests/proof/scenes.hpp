// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes of proofs; extremals of a bead and of η = 0 are known in closed form.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto::testing {

/// Enough for these scenes.
inline constexpr int kBits = 128;

inline Scene bead() {
  Scene scene;
  scene.body = Body::bead();
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

/// Of the reference case but for the offset.
inline Scene cylinder(double eta_m, double theta_m) {
  Scene scene = bead();
  scene.body = Body::cylinder(1.0 / 3.0, eta_m, theta_m, 0.5);
  return scene;
}

}  // namespace brachisto::testing
