// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How unknowns and constraints along the elements of a mesh stand in the chain
/// of the KKT matrix, and what they weigh.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "brachisto/ocp/layout.hpp"
#include "brachisto/ocp/mesh.hpp"
#include "brachisto/ocp/scheme.hpp"

namespace brachisto::ocp {

/// A link is an element. Its separators are its end nodes, the right one with
/// the multipliers of the last point, which determine that node; the interior
/// is the rest. The global unknown is the border.
///
/// \param num_constraints  those behind the points' are left with the first
///                         node, block 0
[[nodiscard]] nlp::ChainStructure element_chain(const Layout& layout,
                                                const Mesh& mesh,
                                                int num_constraints);

/// The same where points are nodes. Control and limits of the last point of an
/// element stand with its right end: equations about the state of a separator
/// would leave the interior singular. With what rows and columns are
/// multiplied.
///
/// \param of_control  whether a limit depends on the control, by its number
[[nodiscard]] nlp::ChainStructure element_chain(
    const Layout& layout, const Mesh& mesh, int num_constraints,
    const std::vector<bool>& of_control);

/// √h of an element as a power of two: the Hessian by states and controls is of
/// the order of h, as an integral over the element, the Jacobian of order one;
/// both are with √h between them.
[[nodiscard]] double root_of_length(const Mesh& mesh, int element);

/// Of variables, then constraints, where points are nodes: h b of a point's
/// states and limits, b of its control and its defects, 1 of others.
[[nodiscard]] std::vector<double> element_weights(
    const Layout& layout, const CollocationScheme& scheme, const Mesh& mesh,
    int num_constraints);

}  // namespace brachisto::ocp
