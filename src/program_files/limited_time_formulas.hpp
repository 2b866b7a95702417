// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The formulas of a limited_time problem.

#pragma once

#include "program_files/program_in_formulas.hpp"
#include "transcription/limited_time.hpp"

namespace brachisto::program_files {

/// Collocation points are nodes, so that there are no quantities. The
/// objective's parts are those of the points, h_e b_j U √A.
class LimitedTimeFormulas final : public ProgramInFormulas {
 public:
  explicit LimitedTimeFormulas(const LimitedTime& problem)
      : problem_(problem) {}

  [[nodiscard]] int num_quantities() const override { return 0; }
  /// \pre there are some
  [[nodiscard]] Formula quantity(int /*index*/) const override { return {}; }
  [[nodiscard]] int num_objective_parts() const override;
  [[nodiscard]] Formula objective_part(int point) const override;
  [[nodiscard]] Formula constraint(int index) const override;

 private:
  [[nodiscard]] const VariableLayout& layout() const {
    return problem_.layout();
  }
  /// Of a node; θ of a body without one is 0.
  [[nodiscard]] Formula state(int node, StateComponent component) const;
  /// Of a collocation point.
  [[nodiscard]] TurningPoint<Formula> turning_point(int point) const;
  [[nodiscard]] Formula duration(int point) const;  ///< h_e U
  [[nodiscard]] Formula defect(int point, StateComponent component) const;
  [[nodiscard]] Formula limit_at_rest(int limit) const;
  [[nodiscard]] Formula contact(int number) const;

  const LimitedTime& problem_;
};

}  // namespace brachisto::program_files
