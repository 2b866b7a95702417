// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Roots of scalar equations.

#pragma once

#include <functional>

namespace brachisto::math {

/// Root of a continuous f with f(lower) f(upper) ≤ 0, to the last bit that
/// rounding of f allows (Alefeld, Potra and Shi's algorithm 748).
///
/// \throws std::domain_error if f has the same sign at both ends
[[nodiscard]] double find_root(const std::function<double(double)>& f,
                               double lower, double upper);

/// The same with the values at the ends, where they are known better than f
/// gives them: rounding may turn the sign of one that is next to zero.
[[nodiscard]] double find_root(const std::function<double(double)>& f,
                               double lower, double upper, double f_lower,
                               double f_upper);

}  // namespace brachisto::math
