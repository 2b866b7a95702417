// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random scenes of a campaign.

#pragma once

#include <cstdint>
#include <numbers>

#include "brachisto/model/scene.hpp"

namespace brachisto::benchmarks {

inline constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

/// Scene number `index` of the campaign with this seed; it does not depend on
/// the other scenes. With H = 1, uniformly
///
///     L in [0.8, 8), r in [0.05, 0.6), k in [0.02, 0.95),
///     η in [0, √(1 − k)), θ_m in [−b, b), b = `largest_angle` [rad].
[[nodiscard]] Scene random_scene(std::uint64_t seed, int index,
                                 double largest_angle = kQuarterTurn);

}  // namespace brachisto::benchmarks
