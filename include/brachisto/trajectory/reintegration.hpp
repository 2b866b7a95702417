// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion integrated again, in physical time.

#pragma once

#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// What a body does that is released from rest on the found path, beside what
/// the solution says. All numbers relative or in natural units.
struct Reintegration {
  double time_error = 0.0;      ///< |T' − T| / T
  double speed_error = 0.0;     ///< |v' − v| / v at the end
  double position_error = 0.0;  ///< distance of the end points
  double rotation_error = 0.0;  ///< |θ' − θ| at the end [rad]
  int steps = 0;
  bool arrived = false;  ///< the body reached the end of the path
};

/// Integrates the body's equation of motion, which has one degree of freedom,
///
///     d/dt (A ṡ) − ½ A_s ṡ² = g E_s:   A s̈ = g (sin β + η cos θ) − ½ A_s ṡ²,
///     ẋ = ṡ cos β,  ż = ṡ sin β,  θ̇ = ṡ/r,  A_s = −2η cos(θ − β)(1/r − κ_c),
///
/// with β and κ_c along the path as functions of s, from rest, by an adaptive
/// Runge–Kutta–Fehlberg method of order 8. Neither w nor the rolling time,
/// energy conservation or the objective enter, only the geometry does.
[[nodiscard]] Reintegration reintegrate(const ExtremalCurve& curve);

}  // namespace brachisto
