// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scenes on the way from an ordinary world to another one.

#pragma once

#include "brachisto/model/scene.hpp"

namespace brachisto {

/// The same scene in a uniform field without air, left from rest.
[[nodiscard]] inline Scene in_ordinary_world(Scene scene) {
  scene.world = {};
  return scene;
}

/// A scene on the way from in_ordinary_world(): with so much of its numbers
/// that are 0 there, and of its field, the rest being uniform.
[[nodiscard]] inline Scene part_of_world(Scene scene, double fraction) {
  for (const WorldParameter& parameter : kWorldParameters) {
    if (!parameter.of_field) *parameter.find_in(scene.world) *= fraction;
  }
  scene.world.field_share = fraction;
  return scene;
}

}  // namespace brachisto
