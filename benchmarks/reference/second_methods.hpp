// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Shooting, for classics that have no closed form. No code of the library is
/// used.

#pragma once

namespace brachisto::benchmarks {

/// By Pontryagin's conditions, integrated by Fehlberg's pair of order 7 and 8
/// in long double, −0.3 ≤ u ≤ 1.
[[nodiscard]] double van_der_pol();
[[nodiscard]] double batch_reactor();
/// Of the two switches, with the one constant control between them that keeps
/// x₂/x₁.
[[nodiscard]] double catalyst();
/// By symmetry half of the time: φ turns back where its rate at the middle
/// vanishes.
[[nodiscard]] double robot_arm();
/// Cross range in degrees.
[[nodiscard]] double shuttle();

}  // namespace brachisto::benchmarks
