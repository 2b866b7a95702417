// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which lanes of a factorisation failed, a bit to each.

#pragma once

#include "brachisto/math/index.hpp"
#include "solvers/numeric_factorisation.hpp"

namespace brachisto {

/// The factorisation of a link is taken if the Frobenius norm of its
/// multipliers is at most this: rounding errors are then magnified by less than
/// its square, 1e8, and one step of refinement leaves (1e8 ε)² = 5e-16 of them.
/// A body that sets out from rest needs as much: with 1e3, a bound for ordinary
/// links, 18 % of the links of 40 000 elements failed, many of them near A.
inline constexpr double kLargestNorm = 1e4;

/// Whether a lane has its bit.
[[nodiscard]] inline bool bit(unsigned bits, int i) {
  return ((bits >> at(i)) & 1U) != 0;
}

/// A bit to each lane whose multipliers are too large, or not finite.
[[nodiscard]] inline unsigned grown(const FactorisationOutcome& outcome) {
  unsigned bits = 0;
  for (int b = 0; b < kLanes; ++b) {
    const bool kept = outcome.growth.lane[b] <= kLargestNorm * kLargestNorm;
    if (!kept) bits |= 1U << at(b);
  }
  return bits;
}

/// The pivots in lanes that did not fail.
[[nodiscard]] inline int negative_in(const FactorisationOutcome& outcome,
                                     unsigned failed, int count) {
  int sum = 0;
  for (int b = 0; b < count; ++b) {
    if (!bit(failed, b)) sum += static_cast<int>(outcome.negative.lane[b]);
  }
  return sum;
}

}  // namespace brachisto
