// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The extremal under limits by the indirect method, its arcs being known.

#pragma once

#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "extremal/arc_system.hpp"

namespace brachisto {

/// A number that follows from equations, and by how much it moves with them at
/// most, per unit of their residual: a short arc may end almost anywhere.
struct Loose {
  double value = 0.0, looseness = 0.0;
};

/// Outcome of solve_limited_extremal(), in natural units.
struct LimitedExtremal {
  bool solved = false;
  std::string message;  ///< why not, or what is known of it
  double transit_time = 0.0;
  double error_estimate = 0.0;  ///< relative, of T
  Loose start_angle, end_angle;
  std::vector<Loose> junctions;  ///< u at which arcs end, the last one at B
  arcs::ArcPath path;            ///< if it is solved
  double residual = 0.0;         ///< of all equations, in natural units
  int newton_steps = 0, integration_steps = 0;
};

/// Newton's method for the equations of arcs::ArcSystem, started from a path
/// nearby. Solved is what keeps all limits, with multipliers of the right sign.
/// The time's error is estimated by arcs::refine_root().
///
/// \param natural  the scene in natural units, with limits
[[nodiscard]] LimitedExtremal solve_limited_extremal(const Scene& natural,
                                                     const arcs::Guess& guess,
                                                     const StopCondition& stop);

}  // namespace brachisto
