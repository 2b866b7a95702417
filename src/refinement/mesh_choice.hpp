// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// On which meshes of elements a path is looked for.

#pragma once

#include "brachisto/ocp/mesh.hpp"
#include "refinement/refinement.hpp"

namespace brachisto {

/// That of a problem which asks for so many elements or nodes.
[[nodiscard]] Mesh fixed_mesh(const Discretisation& wanted);

/// What a solution on a much coarser mesh may err by, relative, for that on the
/// mesh which is asked for to be judged by it: it is exact already but for
/// rounding, and degree p + 1 would only cost time and memory.
[[nodiscard]] double largest_error_of_a_judge(double tolerance);

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
