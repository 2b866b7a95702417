// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the first iteration starts.

#pragma once

#include "brachisto/model/cycloid.hpp"
#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/transcription/rolling_time.hpp"

namespace brachisto {

/// The centre on the given cycloid, moved and stretched to run between the end
/// points of `problem`. For a body whose centre of mass lies on its axis, and
/// whose cycloid it is, all defects vanish to the order of the mesh. No
/// multipliers.
[[nodiscard]] PrimalDual cycloid_guess(const RollingTime& problem,
                                       const CycloidArc& arc);

/// The centre on the straight line between the end points of `problem`,
/// accelerated evenly. No multipliers.
[[nodiscard]] PrimalDual straight_guess(const RollingTime& problem);

}  // namespace brachisto
