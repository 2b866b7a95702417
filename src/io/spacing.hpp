// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How values are spread between two ends.

#pragma once

namespace brachisto::io {

enum class Spacing {
  Linear,  ///< equal differences
  Log,     ///< equal ratios
};

/// Value at the fraction part/whole of the way between two ends:
///
///   linear  from (1 − f) + to f,  log  from^(1 − f) to^f,  f = part/whole.
///
/// The ends are exact, and swapping them while f becomes 1 − f gives the same
/// bits; a linear value is rounded three times, whatever its place, and does
/// not depend on the platform.
///
/// \param part, whole  0 ≤ part ≤ whole, whole − part exact
/// \throws ExpressionError  if the value is not finite or, for equal ratios,
///         if the ends are not of one sign, or zero
[[nodiscard]] double between(double from, double to, double part, double whole,
                             Spacing spacing);

}  // namespace brachisto::io
