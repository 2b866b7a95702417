// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The smooth contact at B as an equation to be solved with the problem.

#pragma once

#include "nlp/tangency_condition.hpp"
#include "transcription/transcription.hpp"

namespace brachisto {

/// The tangency condition: the slope of the extremal at its end is the φ from
/// which the end point C_B(φ) was built. With the end's θ, w and costates,
///
///     F = ∂𝓗/∂β at β = φ = η cos(θ − φ)/√A + w (p_z cos φ − p_x sin φ) = 0.
class ContactEquation final : public nlp::TangencyCondition {
 public:
  /// \param problem  with Contact::Smooth; must outlive this
  explicit ContactEquation(Transcription& problem);

  void set_parameter(double phi) override;
  /// May move the problem to x.
  [[nodiscard]] const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) override;

 private:
  Transcription& problem_;
  double phi_ = 0.0;
};

}  // namespace brachisto
