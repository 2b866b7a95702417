// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of a result beyond the solver's word.

#pragma once

#include <optional>
#include <string>
#include <vector>

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

/// One sentence per failed check, with its value and its threshold.
[[nodiscard]] std::vector<std::string> not_verified_because(
    const Certificate& certificate);

/// The answer of the indirect method beside another.
struct CrossCheck {
  bool solved = false;  ///< the indirect method found an extremal
  std::string message;
  double tau = 0.0;
  double error_estimate = 0.0;  ///< relative, of the extremal method
  double difference = 0.0;  ///< relative, |τ − τ_extremal| / τ_extremal
  /// Of a limited track: largest difference of the slopes at A and B [rad], and
  /// of the places where arcs meet, as shares of U.
  std::optional<double> of_slopes = {}, of_junctions = {};
};

}  // namespace brachisto
