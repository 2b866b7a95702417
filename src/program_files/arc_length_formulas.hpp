// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The formulas of an arc_length problem.

#pragma once

#include "program_files/program_in_formulas.hpp"
#include "transcription/arc_length.hpp"

namespace brachisto::program_files {

/// Quantities are, of one piece after the other, what the program says of it:
/// Δx, Δz, r Δθ, the rotation in its middle and the speed w at the node it
/// leads to. The objective's parts are the times of the pieces.
class ArcLengthFormulas final : public ProgramInFormulas {
 public:
  explicit ArcLengthFormulas(const ArcLength& problem) : problem_(problem) {}

  [[nodiscard]] int num_quantities() const override;
  [[nodiscard]] Formula quantity(int index) const override;
  [[nodiscard]] int num_objective_parts() const override;
  [[nodiscard]] Formula objective_part(int index) const override;
  [[nodiscard]] Formula constraint(int index) const override;

 private:
  [[nodiscard]] const VariableLayout& layout() const {
    return problem_.layout();
  }
  enum Part { kDx, kDz, kLength, kMiddle, kSpeed };
  static constexpr int kParts = 5;
  /// Of the piece that leads to `node`, as a quantity.
  [[nodiscard]] static Formula of(int node, Part part) {
    return Formula::quantity(kParts * (node - 1) + part);
  }
  /// Of a node, the start included.
  [[nodiscard]] Formula state(int node, StateComponent component) const;
  [[nodiscard]] static Formula w(int node) {
    return node == 0 ? 0.0 : of(node, kSpeed);
  }
  /// By how much a component grows on the piece that leads to `node`.
  [[nodiscard]] Formula growth(int node, StateComponent component) const {
    return state(node, component) - state(node - 1, component);
  }
  [[nodiscard]] Formula S() const;
  [[nodiscard]] Formula length(int node) const;  ///< r Δθ
  [[nodiscard]] Formula middle(int node) const;  ///< the rotation there
  [[nodiscard]] Formula speed(int node) const;

  const ArcLength& problem_;
};

}  // namespace brachisto::program_files
