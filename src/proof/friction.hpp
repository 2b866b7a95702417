// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The least coefficient of friction that an extremal needs, with its place.

#pragma once

#include <vector>

#include "proof/theorems.hpp"

namespace brachisto::proof {

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
