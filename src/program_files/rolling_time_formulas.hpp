// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The formulas of a rolling_time problem.

#pragma once

#include "program_files/program_in_formulas.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto::program_files {

/// Quantities are the states at the collocation points, x, z, θ, w of one after
/// the other; those on which nothing depends are not used. The objective's
/// parts are those of the points,
///
///     h_e b_j U √A.
class RollingTimeFormulas final : public ProgramInFormulas {
 public:
  explicit RollingTimeFormulas(const RollingTime& problem)
      : problem_(problem) {}

  [[nodiscard]] int num_quantities() const override;
  [[nodiscard]] Formula quantity(int index) const override;
  [[nodiscard]] int num_objective_parts() const override;
  [[nodiscard]] Formula objective_part(int point) const override;
  [[nodiscard]] Formula constraint(int index) const override;

 private:
  [[nodiscard]] const VariableLayout& layout() const {
    return problem_.layout();
  }
  /// A state at a collocation point as a quantity.
  [[nodiscard]] Formula at_point(int point, StateComponent component) const;
  [[nodiscard]] Formula beta(int point) const;
  /// h_e U of the element of a point.
  [[nodiscard]] Formula duration(int point) const;
  [[nodiscard]] Formula root(int point) const;  ///< √A

  const RollingTime& problem_;
};

}  // namespace brachisto::program_files
