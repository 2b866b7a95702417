// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The smooth contact at B for an arc_length problem.

#pragma once

#include <span>

#include "brachisto/nlp/closing_equation.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

/// β_end from transversality: with θ = θ_m + S/r and w at the end and the
/// derivatives −p_x, −p_z of T with respect to the end point,
///
///     η cos(θ − β_end)/√A + w (p_z cos β_end − p_x sin β_end) = 0,
///
/// the minimum of 𝓗 nearest to the slope of the last piece. All its terms have
/// the order of T; a slope extrapolated from the last pieces would not. NaN if
/// there is none.
///
/// \param x, lambda  a solution of `problem`, which is moved there
[[nodiscard]] double end_slope(ArcLength& problem, std::span<const double> x,
                               std::span<const double> lambda);

/// The same condition at β_end = φ, the slope from which the end point C_B(φ)
/// was built, as an equation to be solved with the problem.
class ArcContactEquation final : public nlp::ClosingEquation {
 public:
  /// \param problem  with Contact::Smooth; must outlive this
  explicit ArcContactEquation(ArcLength& problem);

  void set_parameter(double phi) override;
  [[nodiscard]] const nlp::SparseVector& fixed_rates() const override {
    return fixed_rates_;
  }
  /// Moves the problem to x.
  [[nodiscard]] const Linearisation& linearise(
      std::span<const double> x, std::span<const double> lambda) override;

 private:
  ArcLength& problem_;
  double phi_ = 0.0;
  nlp::SparseVector fixed_rates_;
  Linearisation at_;
};

}  // namespace brachisto
