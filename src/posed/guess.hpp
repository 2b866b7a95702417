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

/// L, the rates and the limits at states and controls.
[[nodiscard]] std::vector<double> formulas(const Posed& problem,
                                           const std::vector<double>& yu);

[[nodiscard]] PrimalDual guess(const Posed& problem, const Mesh& mesh);

}  // namespace brachisto::ocp
