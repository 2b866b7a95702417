// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is shown of an extremal of several arcs, or of another world, once it
/// is known to exist.

#pragma once

#include <vector>

#include "proof/arc_system.hpp"
#include "proof/theorems.hpp"

namespace brachisto::proof {

/// Where an arc ends and another one begins.
struct Junction {
  Real place;  ///< x/H of the centre
  Real time;   ///< √(2 g/H) times the time since the start
};

/// All that is shown. Of limits: that the extremal keeps them, strictly where
/// they do not hold, and that multipliers have the sign that Pontryagin's
/// principle asks for. That it is a minimum is not asked.
struct ArcTheorems {
  Enclosures enclosed;
  std::vector<Junction> junctions;
  Theorem legendre;     ///< h_ββ > 0 on free arcs and along boundaries
  Theorem keeps;        ///< all limits, all along
  Theorem multipliers;  ///< have their sign within each arc, and jumps theirs
  Theorem presses, no_fold, no_loop;
};

/// \param root  of which that it exists is shown
/// \throws NotProven  if its motion cannot be enclosed
[[nodiscard]] ArcTheorems prove_arc_theorems(const ArcSystem& system,
                                             const Root& root,
                                             const Accuracy& accuracy);

/// That all limits are kept, strictly where they do not hold.
/// \param root  of which that it exists is shown
/// \throws NotProven  if its motion cannot be enclosed
[[nodiscard]] Theorem prove_limits(const ArcSystem& system, const Root& root,
                                   const Accuracy& accuracy);

/// Shows that the field has the law of one side of its surface all along every
/// chain that starts in the box that was searched.
/// \throws NotProven  if it has not
void stays_on_its_side(const ArcSystem& system, const Root& root,
                       const Accuracy& accuracy);

/// Numbers of the extremal of a chain.
[[nodiscard]] Enclosures enclosures_of(const ArcChain& chain, const Root& root);

/// An extremal of one free arc as the theorems of such have it.
[[nodiscard]] FreeExtremal as_free(const ArcChain& chain, const Root& root);

}  // namespace brachisto::proof
