// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method for the shooting equations.

#pragma once

#include "extremal/shooting_system.hpp"

namespace brachisto::shooting {

/// The equation that the shooting system lacks for its unknowns with η among
/// them: row·q = value.
struct TangencyRow {
  Globals row;
  double value = 0.0;

  /// η is given.
  [[nodiscard]] static TangencyRow offset(double eta) {
    return {Globals::Unit(kEta), eta};
  }
};

struct ShootingOptions {
  StepControl integration;
  double tolerance = 1e-12;  ///< of the scaled correction
  int max_steps = 50;
  /// Damping: smallest share of a Newton step that is tried; 1 for none.
  double smallest_factor = 1e-4;
};

enum class NewtonEnd { Converged, Diverged, MaxSteps, NotEvaluable, Stopped };

struct ShootingResult {
  NewtonEnd end = NewtonEnd::NotEvaluable;
  ChainVector point;
  Linearisation at;  ///< at `point`
  int steps = 0;
  double first_contraction = 0.0;   ///< ‖second correction‖ / ‖first‖
  double last_correction = 0.0;     ///< scaled; not applied
  double last_change_of_phi = 0.0;  ///< its share in φ [rad]
};

/// Damped Newton method with the natural monotonicity test: a step λ Δ is
/// taken if the simplified correction at its end, computed with the same
/// factors, is shorter than (1 − λ/4) ‖Δ‖ (Deuflhard, "Newton Methods for
/// Nonlinear Problems", 2004, sec. 3.3). The test does not depend on how the
/// equations are scaled. Ends when the correction is below the tolerance, or
/// when rounding keeps it from shrinking further.
[[nodiscard]] ShootingResult solve_newton(const ShootingSystem& system,
                                          const ChainVector& start,
                                          const ChainScale& scale,
                                          const TangencyRow& tangency,
                                          const ShootingOptions& options);

}  // namespace brachisto::shooting
