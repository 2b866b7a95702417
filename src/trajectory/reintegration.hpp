// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The motion integrated again, from its equation.

#pragma once

#include <string_view>

#include "trajectory/prescribed_motion.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/limited_curve.hpp"

namespace brachisto {

/// How a motion ended.
enum class MotionEnd {
  Arrived,      ///< at the end of the path
  ComesToRest,  ///< on its way
  PathUndefined,  ///< ∂𝓗/∂β = 0 has no solution: the mesh is much too coarse
  StepTooSmall,  ///< the integrator's accuracy is not to be had
  TooManySteps,
};

/// One sentence for the user.
[[nodiscard]] std::string_view describe(MotionEnd end);

/// What a body does that is released from rest on the found path, beside what
/// the solution says. All numbers relative or in natural units.
struct Reintegration {
  MotionEnd end = MotionEnd::TooManySteps;
  double share = 0.0;       ///< of the path's length that the body came
  double time_error = 0.0;  ///< |T' − T| / T
  /// |T' + p·Δ − T| / T, Δ from where T ends to where the body arrives: the
  /// time to one and the same end point.
  double corrected_time_error = 0.0;
  double speed_error = 0.0;     ///< |v' − v| / v at the end
  double position_error = 0.0;  ///< distance of the end points
  double rotation_error = 0.0;  ///< |θ_m + S/r − θ| at the end [rad]
  int steps = 0;
  double integration_error =
      0.0;  ///< what all steps together may add, relative
  /// Over a limit, with place and speed of that motion, the largest.
  double excess = 0.0;
  double excess_at = 0.0;  ///< σ

  [[nodiscard]] bool arrived() const { return end == MotionEnd::Arrived; }
  /// The largest error of time, speed, place and rotation; NaN if it did not
  /// arrive.
  [[nodiscard]] double worst() const;
};

/// Integrates the body's equation of motion, which has one degree of freedom,
///
///     d/dt (A ṡ) − ½ A_s ṡ² = g E_s:   A s̈ = g (sin β + η cos θ) − ½ A_s ṡ²,
///     ẋ = ṡ cos β,  ż = ṡ sin β,  θ̇ = ṡ/r,  A_s = −2η cos(θ − β)(1/r − κ_c),
///
/// with β and κ_c along the path as functions of s, from rest, by an adaptive
/// Runge–Kutta–Fehlberg method of order 8: first in time, then by the place in
/// the element, which s is a polynomial of, with t' = s'/ṡ, started anew at the
/// end of each element, where the curvature jumps.
/// Neither w nor the rolling time, energy conservation or the objective enter,
/// only the geometry does.
[[nodiscard]] Reintegration reintegrate(const ExtremalCurve& curve);
/// The same under limits, which are looked at on the way: from the first
/// collocation point on, where the speed is that of energy, with κ_c = q/w.
[[nodiscard]] Reintegration reintegrate(const LimitedCurve& curve);

/// The equation of motion, A s̈ = g (sin β + η cos θ) − ½ A_s ṡ², integrated on
/// the path of a motion that arrived, from rest in time, then by the place: the
/// relative error of T or of the end speed, whichever is worse. NaN if it
/// fails.
///
/// \param from  the place q where it begins with the speed that energy gives;
///              0: at rest. Where the curvature is infinite at the start the
///              right-hand side is not smooth next to it.
[[nodiscard]] double reintegration_error(const PrescribedMotion& motion,
                                         double from = 0.0);

}  // namespace brachisto
