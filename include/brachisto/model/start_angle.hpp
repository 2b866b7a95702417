// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The direction in which the fastest track leaves the start.

#pragma once

#include "brachisto/model/body.hpp"

namespace brachisto {

/// Start angle β₀ [rad]: the direction in which a body at rest gains speed
/// fastest.
///
/// Near the start v_c² = 2 g E / A with E ≈ a s, so β₀ maximises a² / A over
/// the directions with a = sin β + η cos θ_m > 0, A = A(θ_m, β). There
///
///     A cos β = a η cos(θ_m − β),
///
/// and the root is unique on that arc. It is π/2 (straight down) for a bead,
/// for η = 0 and for θ_m = 0, and no other than the limit of the extremal's
/// slope at the start.
///
/// \pre the body is valid (validate() of its scene returns nothing)
[[nodiscard]] double start_angle(const Body& body);

}  // namespace brachisto
