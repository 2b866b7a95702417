// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Many scenes solved side by side.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brachisto/study/solution.hpp"

namespace brachisto {

/// A scene and how it is to be solved.
struct SceneToSolve {
  Scene scene;
  SolveOptions options;
};

/// The verified solutions of scenes whose options allow for it
/// (Collocation::in_lanes) and ask for nothing that this way does not have: the
/// principal extremal of a free scene, as accurately as wanted. Of all others
/// nothing: their own solve is for them. No solution depends on which scenes
/// stand beside it.
[[nodiscard]] std::vector<std::optional<Solution>> solve_in_lanes(
    std::span<const SceneToSolve> scenes);

}  // namespace brachisto
