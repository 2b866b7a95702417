// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Exact derivatives of the discrete transit time, chord by chord.

#pragma once

#include <span>
#include <vector>

#include "brachisto/math/jet.hpp"
#include "paper/discrete_variations.hpp"

namespace brachisto::paper {

/// What the time of a chord depends on; the chord's Δz is the difference of the
/// drops, which are z − z_1 or z by the datum.
enum Local { kDx, kLeftDrop, kRightDrop, kLeftTheta, kRightTheta, kNumLocals };

using ChordJet = math::Jet2<double, kNumLocals>;

/// All chords at one point: their times q_i and lengths l_i with first and
/// second derivatives, and the multipliers λ_i of θ_{i+1} = θ_i + l_i/r in
///
///     T = Σ q_i + Σ λ_i (θ_i + l_i/r − θ_{i+1}),
///     λ_i = λ_{i+1} + ∂q_{i+1}/∂θ_{i+1} + ∂q_i/∂θ_{i+1},
///
/// with which ∂T/∂z_j needs the two chords at node j only.
class ChordJets {
 public:
  ChordJets(const DiscreteVariations& system, std::span<const double> unknowns);

  [[nodiscard]] const ChordJet& time(int i) const { return time_[index(i)]; }
  [[nodiscard]] const ChordJet& length(int i) const {
    return length_[index(i)];
  }
  [[nodiscard]] double lambda(int i) const { return lambda_[index(i)]; }
  /// 1/r; 0 if the motion does not depend on θ.
  [[nodiscard]] double turns() const { return turns_; }

  /// ∂T/∂z_j of an inner node; left of it lies chord j − 1.
  [[nodiscard]] double variation(int node) const;

  /// Second derivative of q_i + λ_i l_i/r.
  [[nodiscard]] double curvature(int i, int a, int b) const {
    const std::size_t p = index(a), q = index(b);
    return time(i).second(p, q) + lambda(i) * turns_ * length(i).second(p, q);
  }

 private:
  [[nodiscard]] static std::size_t index(int i) {
    return static_cast<std::size_t>(i);
  }

  double turns_;
  std::vector<ChordJet> time_, length_;
  std::vector<double> lambda_;
};

}  // namespace brachisto::paper
