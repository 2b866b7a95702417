// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Bounds on rounding errors, and numbers so wide that they have none.

#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <limits>

namespace brachisto::testing {

/// count · ε · scale with ε = 2⁻⁵²: what `count` roundings, half an ulp each
/// and as many again from arguments that were themselves rounded, do to a sum
/// whose largest term has the given size.
[[nodiscard]] inline double ulps(double count, double scale = 1.0) {
  return count * std::numeric_limits<double>::epsilon() * scale;
}

/// Fifty digits. Doubles convert to it exactly, so that a formula evaluated
/// literally in it is the exact value for the doubles put in.
using Wide =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                  boost::multiprecision::et_off>;

}  // namespace brachisto::testing
