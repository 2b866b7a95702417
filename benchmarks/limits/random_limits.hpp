// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random scenes under random limits.

#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "brachisto/model/scene.hpp"

namespace brachisto::benchmarks {

struct LimitedScene {
  Scene scene;
  double free_tau;  ///< without its limits
};

/// A scene without limits, number `index` of a campaign, with one to three of
/// six limits, each bound from 0.7 to 1.3 of what the free extremal keeps to
/// for 95 % of the time; the slopes at the contacts free where that is well
/// posed, in half of the cases. It need not be valid. Nothing if the scene
/// without limits is not verified.
[[nodiscard]] std::optional<LimitedScene> under_random_limits(
    Scene scene, std::uint64_t seed, int index);

/// Gives it rolling resistance c from 0.002 to 0.05, and R_n ≥ 0 where
/// neither friction nor a least load keeps it.
void add_losses(Scene& scene, std::uint64_t seed, int index);

/// The same of random_scene().
[[nodiscard]] std::optional<LimitedScene> random_limited_scene(
    std::uint64_t seed, int index);

/// "optimal hump 1.2 valley 2 rolling 0.01": contact, limits and losses.
[[nodiscard]] std::string described(const Scene& scene);

}  // namespace brachisto::benchmarks
