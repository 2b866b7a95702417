// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The smooth contact at B: an end angle that reproduces itself.

#pragma once

#include <functional>
#include <optional>

namespace brachisto {

/// How the iteration for φ ended.
struct Tangency {
  double phi = 0.0;       ///< φ of the last pass [rad]
  double mismatch = 0.0;  ///< β_end(φ) − φ of the last pass [rad]
  double slope = -1.0;    ///< d(mismatch)/dφ as last seen
  int passes = 0;         ///< how often β_end was evaluated
  bool closed = false;    ///< |mismatch| is below the tolerance, or below the
                          ///< looser one and at the level of rounding
};

/// Options of close_contact().
struct TangencyOptions {
  double tolerance = 1e-12;        ///< on |β_end(φ) − φ| [rad]
  double loose_tolerance = 1e-10;  ///< good enough where a further step no
                                   ///< longer halves the mismatch [rad]
  double initial_slope = -1.0;  ///< d(mismatch)/dφ for the first step; −1 is
                                ///< plain substitution
  int max_passes = 30;
  double first_step = 0.25;  ///< bound on the change of φ in one pass until the
                             ///< root is bracketed [rad]
};

/// Finds φ with β_end(φ) = φ, where β_end(φ) is the end slope of the fastest
/// path between the fixed points C_A and C_B(φ).
///
/// The contact is not a constraint of that minimisation: an optimiser that may
/// choose φ bends the last element and reports a time that is too short. It is
/// one scalar equation around a well-posed problem, solved here by the secant
/// method. Two values of different sign bracket a root; from then on steps that
/// leave the bracket are replaced by bisection.
///
/// \param end_slope  β_end(φ), or nothing if the problem could not be solved at
///                   that φ, which ends the iteration
[[nodiscard]] Tangency close_contact(
    const std::function<std::optional<double>(double phi)>& end_slope,
    double phi_start, const TangencyOptions& options = {});

}  // namespace brachisto
