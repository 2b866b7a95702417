// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Newton's method for the equations of arcs.

#pragma once

#include <limits>

#include "extremal/arc_system.hpp"

namespace brachisto::arcs {

/// Newton's method ended, and where.
struct ArcRoot {
  bool converged = false;
  ArcSystem::Point point;
  ArcSystem::Linearisation at;  ///< no links if a piece cannot be integrated
  int steps = 0;
  double residual = std::numeric_limits<double>::infinity();
};

/// Steps are halved until the residual shrinks. Ends where it is rounding.
[[nodiscard]] ArcRoot find_root(const ArcSystem& system, ArcSystem::Point start,
                                const ocp::StepControl& control,
                                int most_steps);

/// A root as accurate as it gets, by two steps with the derivatives at hand and
/// all steps of the integration halved. The error of T is estimated by what the
/// first one changes, by twice what the second one does, which is rounding,
/// and by the rounding of independent steps.
struct RefinedRoot {
  ArcSystem::Point point;
  /// Values with the steps halved, before the last change.
  ArcSystem::Linearisation at;
  double transit_time = 0.0;
  double error_estimate = 0.0;  ///< relative, of it
};
/// \param root  converged
/// \return false if it cannot be integrated so
[[nodiscard]] bool refine_root(const ArcSystem& system, const ArcRoot& root,
                               const ocp::StepControl& control,
                               RefinedRoot& out);

}  // namespace brachisto::arcs
