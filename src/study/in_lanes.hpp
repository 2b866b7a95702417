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
/// principal extremal of a free scene, or of one whose limits it keeps clear of,
/// as accurately as wanted. Of all others nothing: their own solve is for them.
/// No solution depends on which scenes stand beside it.
[[nodiscard]] std::vector<std::optional<Solution>> solve_in_lanes(
    std::span<const SceneToSolve> scenes);

/// The same for a search that solves what it comes to anew: without
/// certificates and diagnostics, with no more steps than the tolerance needs,
/// and without limits.
///
/// \param beside  a solution of this kind not far from all of them, which they
///                are sought next to first; of another kind or null: nothing
[[nodiscard]] std::vector<std::optional<Solution>> seek_in_lanes(
    std::span<const SceneToSolve> scenes, const Solution* beside);

}  // namespace brachisto
