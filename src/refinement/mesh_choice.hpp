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

/// What another slope takes off 𝓗, from which on it is not the mesh that errs.
inline constexpr double kAnotherSlope = 1e-3;

/// Whether some slope makes 𝓗 smaller by more than that at an end of an
/// element. The collocation then alternates between two minima of 𝓗, and finer
/// meshes do not become accurate.
[[nodiscard]] bool another_slope_is_faster(const ExtremalCurve& curve);

}  // namespace brachisto
