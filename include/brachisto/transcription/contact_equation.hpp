// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The smooth contact at B as an equation to be solved with the problem.

#pragma once

#include "brachisto/nlp/closing_equation.hpp"
#include "brachisto/transcription/rolling_time.hpp"

namespace brachisto {

/// The slope of the extremal at its end is the φ from which the end point
/// C_B(φ) was built: with end states θ, w and the constant costates p_x, p_z,
///
///     F = ∂𝓗/∂β at β = φ = η cos(θ − φ)/√A + w (p_z cos φ − p_x sin φ) = 0.
///
/// p_x = −λ_x/b and p_z likewise are read at the last collocation point.
class ContactEquation final : public nlp::ClosingEquation {
 public:
  /// \param problem  with Contact::Smooth; must outlive this
  explicit ContactEquation(RollingTime& problem);

  void set_parameter(double phi) override;
  [[nodiscard]] const nlp::SparseVector& fixed_rates() const override {
    return fixed_rates_;
  }
  [[nodiscard]] const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) override;

 private:
  RollingTime& problem_;
  double phi_ = 0.0;
  nlp::SparseVector fixed_rates_;
  Linearisation at_;
};

}  // namespace brachisto
