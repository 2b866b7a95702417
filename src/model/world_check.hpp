// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a scene's world may be.

#pragma once

#include "brachisto/model/scene.hpp"
#include "model/scene_checker.hpp"

namespace brachisto {

/// Checks of validate() for scenes whose world is not ordinary.
void check_world(const Scene& scene, SceneChecker& check);

}  // namespace brachisto
