// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Closed forms of the classics, and shooting where there is none. No code of
/// the library is used.

#pragma once

namespace brachisto::benchmarks {

/// Of a cycloid from rest to (L, 1), g = 1/2: one equation for its angle.
[[nodiscard]] double cycloid_time(double L);
/// To the line x = 1 without a wall, and under y ≤ x/2 + 0.1: two cycloids with
/// the slope of the wall at its ends, and a straight slide between them.
[[nodiscard]] double time_to_line(double g);
[[nodiscard]] double time_along_wall(double g);
/// ∫ x ds of a catenary through (0, 1) and (1, 3) with the length 4.
[[nodiscard]] double hanging_chain();
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

}  // namespace brachisto::benchmarks
