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

/// The residual that the optimality conditions may have.
inline constexpr double kAsCertified = 1e-7;

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

/// What a path may gain between its points, where no equation and no bound is
/// asked for, to first order and as a sum of absolute values: the largest
/// excess over each bound of states and limits, times the bound's price, and
/// what the equations are missed by on each element, by costates.
[[nodiscard]] double cost_between_points(
    const Posed& problem, const MeshPath& path,
    const std::vector<Answer::Price>& prices);

/// Where a formula jumps along a path, in words; empty if none does.
[[nodiscard]] std::string jump_along(const Posed& problem,
                                     const MeshPath& path);

}  // namespace brachisto::ocp
