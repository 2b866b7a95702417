// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes whose extremals are known in closed form.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto::testing {

inline Scene bead() {
  Scene scene;
  scene.body = Body::bead();
  scene.L = 3.0;
  scene.H = 1.0;
  return scene;
}

}  // namespace brachisto::testing
