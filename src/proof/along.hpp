// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is looked at along the steps of an extremal: Weierstrass' excess, and
/// the least coefficient of friction with its place.

#pragma once

#include <array>
#include <vector>

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

/// max |R_t|/R_n from a share of T on: pieces of the way whose enclosures
/// exceed what is surely needed somewhere are cut until they are narrow.
class FrictionAlong {
 public:
  /// \param time  T
  FrictionAlong(const Equations& equations, double share, const Real& time)
      : equations_(equations), share_(share), from_(Real(share) * time) {}

  void look(const Step& step);
  /// x from the start, in own units, for its place.
  [[nodiscard]] Friction found() const;

  /// Of μ, relative.
  static constexpr double kTolerance = 1e-12;

 private:
  struct Piece {
    Real mu, x;
  };
  [[nodiscard]] Real needed(const Step& step, const Real& u) const;
  [[nodiscard]] Real first_time(const Step& step) const;

  const Equations& equations_;
  double share_;
  Real from_;
  bool inside_ = false;
  bool enclosed_ = true;
  double least_ = 0.0;  ///< is needed somewhere
  std::vector<Piece> narrow_;
};

}  // namespace brachisto::proof
