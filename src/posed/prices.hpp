// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the least cost changes by with what is given and with bounds.

#pragma once

#include "brachisto/posed/problem.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// What the variables' bounds leave: multipliers times distances, summed.
[[nodiscard]] double left_by_bounds(const nlp::Problem& program,
                                    const PrimalDual& point);

/// From multipliers, in the problem's own units. The program has been moved to
/// the point.
void put_prices(const Posed& problem, nlp::Problem& program,
                const MeshPath& path, const PrimalDual& point, Answer& answer);

}  // namespace brachisto::ocp
