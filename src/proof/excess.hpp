// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Weierstrass' excess along an extremal.

#pragma once

#include <array>

#include "proof/theorems.hpp"

namespace brachisto::proof {

/// What the excess is along the steps of an extremal. With 𝓗 = 0 = h_β at its
/// own slope β it is
///
///     E(δ) = 𝓗(y, p, β + δ),  E(0) = E'(0) = 0.
///
/// It is positive for δ ≠ 0 where E'' > 0 from 0 on, and beyond by its values;
/// both on sectors of δ.
class ExcessAlong {
 public:
  explicit ExcessAlong(const Scene& scene) : of_slope_(scene) {}

  void look(const Step& step);
  [[nodiscard]] Excess found() const;

 private:
  static constexpr int kHalf = 24;  ///< sectors on either side of β
  using Sectors = std::array<bool, 2 * kHalf>;

  void look(const Step& step, const Real& from, const Real& to, int pieces);
  /// \return which of them are shown over the whole piece
  [[nodiscard]] Sectors over(const std::vector<Real>& y,
                             const Sectors& asked) const;

  SlopeFunction of_slope_;
  Sectors missing_{};
  Sectors wanted_{};
  Theorem theorem_{.holds = true};
};

}  // namespace brachisto::proof
