// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What an answer to a stated problem is asked.

#pragma once

#include <string>
#include <vector>

#include "brachisto/posed/problem.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// Residual of the optimality conditions, states integrated anew, limits
/// between the points, a constant 𝓗, the estimate, and second order.
///
/// \param exact  whether it is known which bounds hold as equations; else
///               second order is not asked for
[[nodiscard]] std::vector<Check> certify(
    const Posed& problem, nlp::Problem& program, const PrimalDual& point,
    const MeshPath& path, double relative_error, double tolerance, bool exact);

/// Where a formula jumps along a path, in words; empty if none does.
[[nodiscard]] std::string jump_along(const Posed& problem,
                                     const MeshPath& path);

}  // namespace brachisto::ocp
