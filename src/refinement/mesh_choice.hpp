// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// On which meshes of elements a path without limits is looked for.

#pragma once

#include "brachisto/ocp/mesh.hpp"
#include "refinement/refinement.hpp"

namespace brachisto {

/// That of a problem which asks for so many elements or nodes.
[[nodiscard]] Mesh fixed_mesh(const Discretisation& wanted);

/// The mesh on which `curve` promises the wanted relative error, at the degree
/// to start with.
[[nodiscard]] Mesh first_mesh(const Discretisation& wanted, double tolerance,
                              const ExtremalCurve& curve);

/// The next mesh to try after `answer` missed `tolerance`: the next degree on
/// the same elements where that will do, otherwise elements of the same degree
/// that share the error evenly.
[[nodiscard]] Mesh next_mesh(const MeshAnswer& answer, double tolerance,
                             bool degree_is_fixed);

/// Whether another slope makes 𝓗 far smaller somewhere: the fastest path turns
/// on the spot there, and no mesh of a smooth one becomes accurate.
[[nodiscard]] bool turns_on_the_spot(const ExtremalCurve& curve);

}  // namespace brachisto
