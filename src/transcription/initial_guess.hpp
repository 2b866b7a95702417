// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the first iteration starts.

#pragma once

#include <cstdint>

#include "brachisto/nlp/problem.hpp"
#include "model/cycloid.hpp"
#include "transcription/limited_time.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// The centre on the given cycloid, moved and stretched to run between the end
/// points of `problem`. For a body whose centre of mass lies on its axis, and
/// whose cycloid it is, all defects vanish to the order of the mesh. No
/// multipliers.
[[nodiscard]] PrimalDual cycloid_guess(const RollingTime& problem,
                                       const CycloidArc& arc);

/// The same under limits; where the contacts of `problem` are free the cycloid
/// keeps its own ends.
[[nodiscard]] PrimalDual cycloid_guess(const LimitedTime& problem,
                                       const CycloidArc& arc);

/// The first with the multipliers of the axisymmetric body, for which this is
/// the extremal itself: with 𝓗 = ∂𝓗/∂β = 0 along the cycloid,
///
///     w p_x = −√A cos β,  w p_z + g p_w = −√A sin β,  p_θ = 0,  A = 1 + k,
///
/// p_x and p_z constant and p_w = 0 at the end. Where a continuation starts.
[[nodiscard]] PrimalDual cycloid_extremal(const RollingTime& problem,
                                          const CycloidArc& arc);

/// The centre on the straight line between the end points of `problem`,
/// accelerated evenly. No multipliers.
[[nodiscard]] PrimalDual straight_guess(const RollingTime& problem);

/// The cycloid guess with a random amount, up to 0.5 rad, added to every slope
/// angle and every speed changed by a random factor between 1/2 and 3/2. The
/// same seed gives the same guess everywhere. No multipliers.
[[nodiscard]] PrimalDual random_guess(const RollingTime& problem,
                                      const CycloidArc& arc,
                                      std::uint64_t seed);

}  // namespace brachisto
