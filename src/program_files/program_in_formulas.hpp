// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A nonlinear program as formulas, one at a time.

#pragma once

#include <memory>

#include "program_files/formula.hpp"
#include "transcription/transcription.hpp"

namespace brachisto {
class ArcLength;
class LimitedTime;
class RollingTime;
}  // namespace brachisto

namespace brachisto::program_files {

/// The objective and the constraints of a program in its unknowns, numbered as
/// the program numbers them. Formulas are made when they are asked for, so that
/// no more than one element's need be in memory.
class ProgramInFormulas {
 public:
  virtual ~ProgramInFormulas() = default;

  /// Quantities that several formulas use, each a formula of unknowns alone.
  [[nodiscard]] virtual int num_quantities() const = 0;
  [[nodiscard]] virtual Formula quantity(int index) const = 0;
  /// The objective is the sum of its parts.
  [[nodiscard]] virtual int num_objective_parts() const = 0;
  [[nodiscard]] virtual Formula objective_part(int index) const = 0;
  [[nodiscard]] virtual Formula constraint(int index) const = 0;
};

/// The formulas of a program, which has to outlive them and stay as it is.
[[nodiscard]] std::unique_ptr<ProgramInFormulas> in_formulas(
    const Transcription& problem);
[[nodiscard]] std::unique_ptr<ProgramInFormulas> in_formulas(
    const RollingTime& problem);
[[nodiscard]] std::unique_ptr<ProgramInFormulas> in_formulas(
    const LimitedTime& problem);
[[nodiscard]] std::unique_ptr<ProgramInFormulas> in_formulas(
    const ArcLength& problem);

}  // namespace brachisto::program_files
