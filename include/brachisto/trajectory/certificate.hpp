// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of a result beyond the solver's word.

#pragma once

#include <string>
#include <vector>

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/trajectory/trajectory.hpp"
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

/// Thresholds of the checks, each for a number without unit: lengths in units
/// of max(L, H), speeds of √(2 g max(L, H)).
struct CertificateThresholds {
  /// The solver's default tolerance is 1e-12; a residual ε changes τ by about
  /// ε times the sum of multipliers, so 1e-9 keeps eight digits at the worst.
  double kkt_residual = 1e-9;
  double defects = 1e-9;
  double contact_error = 1e-9;
  /// τ changes by (r √A / w) per radian of mismatch.
  double closure = 1e-8;
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

/// Tests a solution of `problem` found with the end angle φ:
///
///   kkt_residual    stationarity, recomputed outside the solver
///   defects         equality constraints, likewise
///   contact_error   distance of the track's ends from A and B
///   closure         |β_end(φ) − φ|, for Contact::Smooth
///   slope_angle     continuous slope angle within [−π, π]: no loop
///   speed           share of the places after the start without w > 0
[[nodiscard]] Certificate certify(RollingTime& problem, const PrimalDual& point,
                                  double phi,
                                  const CertificateThresholds& thresholds = {});

}  // namespace brachisto
