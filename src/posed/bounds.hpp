// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which bounds hold along a path, and what the least cost changes by with them
/// and with what is given.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/posed/problem.hpp"
#include "nlp/active_set.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// Of each collocation point, for each state, control and limit in this order.
using HeldAlong = std::vector<std::vector<nlp::Held>>;

/// \param between  how far from its bound, scaled, what lies between two held
///                 places may be to be held too
/// \pre  the program has been moved to the point
[[nodiscard]] HeldAlong held_along(nlp::Problem& program,
                                   const PrimalDual& point, const Mesh& mesh,
                                   const Layout& layout, double between = 1e-4);

/// What the variables' bounds leave: multipliers times distances, summed.
[[nodiscard]] double left_by_bounds(const nlp::Problem& program,
                                    const PrimalDual& point);

/// From multipliers, in the problem's own units. The program has been moved to
/// the point.
void put_prices(const Posed& problem, nlp::Problem& program,
                const MeshPath& path, const PrimalDual& point, Answer& answer);

}  // namespace brachisto::ocp
