// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A mesh of which some boundaries are unknowns: where a control jumps.

#pragma once

#include <optional>
#include <vector>

#include "posed/on_mesh.hpp"

namespace brachisto::ocp {

/// The solution on a mesh whose given boundaries go to where the cost is least.
/// There 𝓗 is the same on both sides, and between two bang–bang arcs nothing
/// else is left to reach the end with.
///
/// Nothing if that is not solved to the last digit, or if on some element a
/// bound holds at some of the points and not at others: then there is another
/// junction.
///
/// \param boundaries  numbers of inner boundaries, ascending
/// \return the mesh with its boundaries where they belong, and the program with
///         these as its last variables
[[nodiscard]] std::optional<OnMesh> with_free_junctions(
    const Posed& problem, MeshSolver& solver, const Mesh& mesh,
    const std::vector<int>& boundaries, const MeshPath& nearby,
    int most_iterations);

}  // namespace brachisto::ocp
