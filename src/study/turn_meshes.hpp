// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Uniform meshes for the number of turns that a body makes: each turn makes
/// the track go up and down once.

#pragma once

#include "brachisto/model/cycloid.hpp"
#include "brachisto/transcription/mesh.hpp"

namespace brachisto {

/// Good enough to tell branches apart: τ is right to six digits or so.
/// \param arc  the path of the uniform cylinder
[[nodiscard]] Mesh coarse_mesh(const Scene& scene, const CycloidArc& arc);

/// A mesh that can represent an extremal whose centre runs so far.
[[nodiscard]] Mesh sampled_mesh(const Body& body, double length);

/// A mesh of the highest degree on which an extremal of that length is so well
/// represented that it may be judged there.
[[nodiscard]] Mesh fine_mesh(const Body& body, double length);

}  // namespace brachisto
