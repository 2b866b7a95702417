// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether a function of u is positive, shown or refuted by enclosures.

#pragma once

#include "proof/real.hpp"

namespace brachisto::proof {

enum class Sign { Positive, Unknown, Refuted };

/// All from one end to the other.
[[nodiscard]] inline Real hull(const Real& from, const Real& to) {
  Real out;
  arb_union(out.get(), from.get(), to.get(), working_bits);
  return out;
}

/// The sign all along, the way cut into pieces if need be. It is refuted if the
/// function is negative at a point, which is then written down.
/// \param value  encloses the function over an interval of u
template <class Value>
[[nodiscard]] Sign sign_along(const Real& from, const Real& to,
                              const Value& value, Real& where, int pieces = 1) {
  constexpr int kMostPieces = 128;
  constexpr double kSplit = 0.5;
  if (value(hull(from, to)).positive()) return Sign::Positive;
  const Real middle = ((from + to) * Real(kSplit)).middle();
  if ((-value(middle)).positive()) {
    where = middle;
    return Sign::Refuted;
  }
  if (2 * pieces > kMostPieces) return Sign::Unknown;
  const Sign first = sign_along(from, middle, value, where, 2 * pieces);
  if (first == Sign::Refuted) return first;
  const Sign second = sign_along(middle, to, value, where, 2 * pieces);
  return first == Sign::Unknown && second == Sign::Positive ? first : second;
}

}  // namespace brachisto::proof
