// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the search of a stated problem begins.

#pragma once

#include <cstddef>
#include <string>

#include "brachisto/posed/problem.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// Of states, then parameters, then controls.
[[nodiscard]] const Variable& variable(const Statement& said, std::size_t i);

/// Where a collocation point is, 0 … 1.
[[nodiscard]] double sigma(const Mesh& mesh, int point);

[[nodiscard]] PrimalDual guess(const Posed& problem, const Mesh& mesh);

/// Which formula is not finite on a path, and where; empty if all are.
[[nodiscard]] std::string not_finite(const Posed& problem,
                                     const MeshPath& path);

}  // namespace brachisto::ocp
