// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The slope at A as an equation beside the problem, where it is open.

#pragma once

#include <array>
#include <vector>

#include "nlp/tangency_condition.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// The slope with which the extremal leaves A is the α from which its start
/// X₀(α) was built. With the costates there, which are the Lagrangian's slope
/// over the values of the fixed start, p(0) = ∂𝓛/∂X₀,
///
///     F = ∂𝓗/∂β at X₀, p(0) and β = α.
///
/// Costates integrated from the end are the same at a solution.
class StartEquation final : public nlp::TangencyCondition {
 public:
  /// \param problem  with slope_at_A_is_open(); must outlive this
  explicit StartEquation(RollingTime& problem);

  void set_parameter(double alpha) override;
  /// Moves the problem to x.
  [[nodiscard]] const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) override;

 private:
  /// An entry of a matrix in the row of one state of the start.
  struct Entry {
    std::size_t state;
    int other;  ///< a variable, or a constraint
    std::size_t place;
  };

  RollingTime& problem_;
  double alpha_ = 0.0;
  std::vector<StateComponent> states_;
  std::vector<Entry> of_hess_, of_jac_;
};

}  // namespace brachisto
