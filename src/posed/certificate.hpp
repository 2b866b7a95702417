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

/// Residual of the optimality conditions. What bounds leave is in the units of
/// the cost, in which it counts in the estimate, and not per length: impulses
/// at junctions, which limits of states have, are none of the path's functions.
[[nodiscard]] nlp::KktResidual first_order(nlp::Problem& program,
                                           const PrimalDual& point);

/// Residual of the optimality conditions, states integrated anew, limits
/// between the points, a constant 𝓗, the estimate, and second order.
///
/// \param exact  whether it is known which bounds hold as equations; else
///               second order is not asked for
[[nodiscard]] std::vector<Check> certify(
    const Posed& problem, nlp::Problem& program, const PrimalDual& point,
    const MeshPath& path, double relative_error, double tolerance, bool exact);

/// What a path gains by exceeding bounds of states and limits between the
/// points: the most by which it does, times the bounds' prices. On the widened
/// bounds it is a path, so that the least cost is higher by no more.
[[nodiscard]] double cost_of_excess(const Posed& problem, const MeshPath& path,
                                    const std::vector<Answer::Price>& prices);

/// Where a formula jumps along a path, in words; empty if none does.
[[nodiscard]] std::string jump_along(const Posed& problem,
                                     const MeshPath& path);

}  // namespace brachisto::ocp
