// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether limits of forces and curvature let an off-centred body come down.

#pragma once

#include <string_view>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "model/path_inequality.hpp"

namespace brachisto {

/// False only if no path without a loop keeps the limits of forces and
/// curvature down to the height of B, wherever it lies there. For each slope
/// and each turn of the body an upper bound of its energy height E is carried
/// on from step to step of θ, over however many turns, until it grows no more:
/// E' = r (sin β + η cos θ) whatever the track does, and how far β turns within
/// a step is bounded by the limits, each of which is
///
///     c_0(θ, β) + E (c_1(δ) − c_2(δ) κ) ≥ 0.
///
/// The energy that B asks for is known at each θ and β. Functions are enclosed
/// over the places that a step may come to. Below a fiftieth of H energy counts
/// as attained everywhere, and what a push gives at the start as attained
/// there. Nothing is said of bodies whose mass is on their axis, of fields, air
/// and losses, and where curvature to one side has no bound.
/// \throws Stopped  see check_stop()
[[nodiscard]] bool comes_down(const Scene& scene,
                              const std::vector<PathInequality>& limits);

/// What to say where it does not.
inline constexpr std::string_view kTooFast =
    "no path without a loop leads as deep as B under these limits: as it turns "
    "the body's own mass, which is off its centre, loads the track more than "
    "the limits allow or lifts it off before the body is fast enough, however "
    "the track bends within them";

}  // namespace brachisto
