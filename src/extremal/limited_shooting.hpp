// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremal under limits by the indirect method, its arcs being known.

#pragma once

#include <string>
#include <vector>

#include "brachisto/math/stop_condition.hpp"
#include "extremal/limited_system.hpp"

namespace brachisto {

/// Outcome of solve_limited_extremal(), in natural units.
struct LimitedExtremal {
  bool solved = false;
  std::string message;  ///< why not, or what is known of it
  double transit_time = 0.0;
  double error_estimate = 0.0;  ///< relative, of T
  double start_angle = 0.0, end_angle = 0.0;
  std::vector<double> junctions;  ///< u at which arcs end, the last one at B
  /// By how much each of them moves with the equations at most, per unit of
  /// their residual: a short arc may end almost anywhere.
  std::vector<double> looseness;
  double residual = 0.0;  ///< of all equations, in natural units
  int newton_steps = 0, integration_steps = 0;
};

/// Newton's method for the equations of LimitedSystem, started from a path
/// nearby. Solved is what keeps all limits, with multipliers of the right sign.
/// The time's error is estimated by one step more, with all steps of the
/// integration halved.
///
/// \param natural  the scene in natural units, with limits
[[nodiscard]] LimitedExtremal solve_limited_extremal(
    const Scene& natural, const limited::Guess& guess,
    const StopCondition& stop);

}  // namespace brachisto
