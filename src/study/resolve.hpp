// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a coarse extremal to one that is accurate between the nodes too.

#pragma once

#include <functional>

#include "brachisto/trajectory/motion.hpp"
#include "refinement/refinement.hpp"
#include "search/global_search.hpp"

namespace brachisto {

/// Refines until T is as accurate as wanted and, where the path bends sharply,
/// until it is resolved between the nodes too.
///
/// \param scene     in natural units
/// \param wanted    of the first round, the tolerance a hundredth in the next
/// \param from      on a coarse mesh
/// \param options   of each round
/// \param conclude  judges what a round came to; without a certificate it was
///                  the last one
void refine_until_resolved(
    const Scene& scene, Discretisation wanted, ContactCandidate from,
    const std::function<MeshOptions()>& options,
    const std::function<const Certificate*(Refinement)>& conclude);

}  // namespace brachisto
