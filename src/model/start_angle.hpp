// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The direction in which every extremal leaves the start.

#pragma once

#include "brachisto/model/body.hpp"
#include "brachisto/model/scene.hpp"

namespace brachisto {

/// Start angle β₀ [rad]: the direction in which every extremal leaves the
/// start.
///
/// From rest w = √(2 g E) grows in time like g a/√A, and β₀ makes that growth
/// largest: it maximises a²/A over the directions with a = sin β + η cos θ_m >
/// 0 and A = A(θ_m, β). (The speed of the centre grows like g a/A instead.)
/// There
///
///     A cos β = a η cos(θ_m − β),
///
/// and the root is unique on that arc. It is π/2 (straight down) for a bead,
/// for η = 0 and for θ_m = 0, and no other than the limit of the extremal's
/// slope at the start.
///
/// \pre the body is valid (validate() of its scene returns nothing)
[[nodiscard]] double start_angle(const Body& body);

/// Start angle in any world: the one that the start was built from, if that was
/// chosen; otherwise the same law with the field's direction at the centre of
/// mass in place of the vertical, which in the field of a sphere depends on
/// where the centre stands above A and so on β₀ again. Where losses take their
/// part it is the largest growth of what is left.
[[nodiscard]] double start_angle(const Scene& scene);

/// Whether the slope at A is an unknown that the start is built from: with an
/// initial speed the extremal chooses it, and by it the place of the centre
/// above A, and where the centre of mass lies off the axis the energy that the
/// speed v₀ stands for.
[[nodiscard]] bool slope_at_A_is_open(const Scene& scene);

/// w where the motion starts: v₀ √A(θ_m, β₀) [m/s].
[[nodiscard]] double initial_w(const Scene& scene);

}  // namespace brachisto
