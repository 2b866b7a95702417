// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From an extremal that is a saddle down to minima beside it.

#pragma once

#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "refinement/mesh_solve.hpp"
#include "search/global_search.hpp"

namespace brachisto {

/// What lies below a saddle, and what it took to get there.
struct Descent {
  std::vector<ContactCandidate> minima;
  Work work;
};

/// If the extremal is no minimum between its fixed ends, pushes all slopes of
/// its path a little to either side and minimises from there, first between
/// these ends, then with φ following the end slope until the contact is smooth
/// again. A minimiser leaves a saddle along the directions in which T falls;
/// the body then arrives about half a turn earlier or later. What is reached is
/// a minimum between its own fixed ends, on the mesh of the saddle.
///
/// \param scene  in natural units, with Contact::Smooth, or with
///               Contact::Centre, whose ends stay
[[nodiscard]] Descent descend(const Scene& scene,
                              const ContactCandidate& saddle,
                              MeshOptions options);

}  // namespace brachisto
