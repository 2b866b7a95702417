// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Meshes for the number of turns that a body makes: each turn makes the track
/// go up and down once.

#pragma once

#include <optional>
#include <span>

#include "brachisto/ocp/mesh.hpp"
#include "model/cycloid.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// Turns of the body along a path of its centre of length s. None matter to a
/// body that is not off-centred.
[[nodiscard]] double turns(const Body& body, double s);

/// True of so many turns that a branch is better followed turn by turn than at
/// fixed shares of the rolling time.
[[nodiscard]] bool are_many(double turns);

/// The mesh of as many elements on which the body turns by the same angle in
/// each, along the path given by the unknowns of `problem`, whose body turns.
/// \param x  with θ growing from node to node
[[nodiscard]] Mesh mesh_of_equal_turns(const RollingTime& problem,
                                       std::span<const double> x);

/// Good enough to tell branches apart: τ is right to six digits or so.
/// \param arc  the path of the uniform cylinder
[[nodiscard]] Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc);

/// A mesh that can represent an extremal whose centre runs so far.
[[nodiscard]] Mesh sampled_mesh(const Body& body, double length);

/// A mesh of the highest degree on which an extremal of that length is so well
/// represented that it may be judged there.
[[nodiscard]] Mesh fine_mesh(const Body& body, double length);

/// How often its elements have to be halved, and of what degree they have to be
/// at the least, for a mesh to represent turns that do not matter to the path
/// of a body that is not off-centred, but to how it changes with an offset.
struct TurnsResolved {
  int halvings = 0;
  int degree = 0;
};
/// Nothing if no mesh would do that has a reasonable number of elements.
///
/// \param longest  path of the centre along one of the mesh's `elements`
[[nodiscard]] std::optional<TurnsResolved> resolve_turns(const Body& body,
                                                         double longest,
                                                         int elements);

/// Nodes of such a mesh for a path of the centre of that length, at most; 0 of
/// a body that needs none.
[[nodiscard]] double most_resolving_nodes(const Body& body, double length);

}  // namespace brachisto
