// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of a result beyond the solver's word.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/transcription/extremal_curve.hpp"
#include "brachisto/transcription/rolling_time.hpp"

namespace brachisto {

/// One statement about a result that was tested.
struct Check {
  std::string name;        ///< as in result files: "kkt_residual"
  double value = 0.0;      ///< what was found
  double threshold = 0.0;  ///< passed iff value ≤ threshold
  std::string where;       ///< where on the path the value was found, or empty
  bool passed = false;
};

/// Outcome of all checks.
struct Certificate {
  std::vector<Check> checks;

  /// True iff there are checks and all of them passed.
  [[nodiscard]] bool verified() const;
  /// The check of that name, or null.
  [[nodiscard]] const Check* find(const std::string& name) const;
  /// Adds a check; NaN never passes.
  void add(std::string name, double value, double threshold,
           std::string where = {});
};

/// Thresholds of the checks, each for a number without unit: lengths in units
/// of max(L, H), speeds of √(2 g max(L, H)).
struct CertificateThresholds {
  /// The solver's default tolerance is 1e-12; a residual ε changes τ by about
  /// ε times the sum of multipliers, so 1e-9 keeps eight digits at the worst.
  double kkt_residual = 1e-9;
  double defects = 1e-9;
  double contact_error = 1e-9;
  /// τ changes by r √A / w per radian of mismatch.
  double closure = 1e-8;
  /// What is measured between nodes has order p + 1 or, for slopes, p, while T
  /// has order 2p: for a relative error ε of T that makes ε^((p+1)/2p) and
  /// ε^(1/2). The factor allows for the constants, which are of order one to
  /// ten in the cases of the paper.
  double interior_factor = 100.0;
};

/// Tests a solution of `problem` found with the end angle φ, by code that
/// shares only the physics with the optimiser.
///
/// Optimality:
///   kkt_residual     stationarity, in long double and by other derivatives
///   hamiltonian      max |𝓗| / √A between nodes; zero on an extremal
///   slope            max |∂𝓗/∂β| / √A of the interpolated slopes
///   start_angle      slope of the curve at the start against β₀
///   second_order     eigenvalues of the KKT matrix with the wrong sign or none
///   legendre         −min ∂²𝓗/∂β²; below zero on a minimum
/// Integrity:
///   defects          equality constraints, in long double
///   contact_error    distance of the track's ends from A and B
///   closure          |β_end(φ) − φ|, for Contact::Smooth
///   energy_drift     max |w²/2g − E| at element ends
///   reintegration_error  the motion in physical time: the largest relative
///                    error of T and end speed, and of end position and θ
///   slope_angle      continuous slope angle within [−π, π]: no loop
///   speed            share of the places after the start without w > 0
///
/// \param error  relative error of T that the solution has or may have; the
///               thresholds between nodes follow from it
[[nodiscard]] Certificate certify(RollingTime& problem, const PrimalDual& point,
                                  double phi, double error,
                                  const CertificateThresholds& thresholds = {});

}  // namespace brachisto
