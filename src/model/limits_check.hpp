// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The part of validate() that is about limits and the contacts that need them.

#pragma once

#include "model/scene_checker.hpp"

namespace brachisto {

/// Refuses limits that are no limits, that no motion can keep to, or without
/// which a contact leaves no fastest track. What numbers demand of each other
/// is only asked where nothing else was refused.
void check_limits(const Scene& scene, SceneChecker& check);

}  // namespace brachisto
