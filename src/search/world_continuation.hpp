// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the extremal of an ordinary world to that of another one.

#pragma once

#include "search/continuation.hpp"

namespace brachisto {

/// Follows the extremal of a scene from its ordinary world, whose extremal is
/// given with its protocol, into its own. Each step corrects the last solution
/// by Newton's method, and is halved if slopes turn too far for that to be the
/// same extremal.
///
/// \param scene     in natural units
/// \param ordinary  with a curve, of in_ordinary_world(scene)
[[nodiscard]] Continuation continue_into_world(const Scene& scene,
                                               Continuation ordinary,
                                               const StopCondition& stop,
                                               const ProgressHook& progress);

/// Follows the extremal of a scene in its own world from that of a body of
/// next to no offset, which is given with its protocol, in the same way.
///
/// \param scene    in natural units
/// \param uniform  with a curve, of the scene with less η_m
[[nodiscard]] Continuation continue_offset_in_world(
    const Scene& scene, Continuation uniform, const StopCondition& stop,
    const ProgressHook& progress);

}  // namespace brachisto
