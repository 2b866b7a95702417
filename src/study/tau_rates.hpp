// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Of the sensitivities of an answer those that a search asks for.

#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "brachisto/study/solution.hpp"
#include "model/scene_coordinate.hpp"

namespace brachisto {

/// dτ/d(coordinate), per unit of it, the contacts moving along.
struct TauRates {
  std::array<double, kSceneCoordinates.size()> by{};  ///< 0: not asked for
  /// See Sensitivities.
  double contact_response = std::numeric_limits<double>::quiet_NaN();
};

/// As sensitivities(), which has them and more.
[[nodiscard]] std::optional<TauRates> tau_rates(
    const Solution& solution, std::span<const SceneCoordinate> by);

}  // namespace brachisto
