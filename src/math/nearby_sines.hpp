// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Sines of angles that lie close together.

#pragma once

#include <cmath>

namespace brachisto::math {

/// Sine and cosine, in long double, of one angle after the other. Those of an
/// anchor are turned by d, which is where the angle is seen from there, by the
/// addition theorems; where |d| > 1/64 the angle is the next anchor.
///
/// Of sin d = d − d³/3! + d⁵/5! − d⁷/7! and 1 − cos d = d²/2! − … − d⁸/8! what
/// is left out is below 2⁻⁷² and 2⁻⁸¹, rounding of both below 2⁻⁶⁸. The
/// anchor's sines are good to an ulp, 2⁻⁶⁴, and the last sum to half of one:
/// 2⁻⁶³ in all, however many angles there are. Next to the first anchor, 0, the
/// sine keeps its relative accuracy.
class NearbySines {
 public:
  struct Sines {
    long double sine, cosine;
  };
  [[nodiscard]] Sines at(long double angle) {
    constexpr long double kNear = 1.0L / 64.0L;
    const long double d = angle - anchor_;
    if (!(std::abs(d) <= kNear)) {  // written so that a NaN stays
      anchor_ = angle;
      return of_anchor_ = {std::sin(angle), std::cos(angle)};
    }
    const long double q = d * d;
    const long double s =
        d *
        (1.0L - q * (1.0L / 6.0L - q * (1.0L / 120.0L - q * (1.0L / 5040.0L))));
    const long double v =
        q * (0.5L -
             q * (1.0L / 24.0L - q * (1.0L / 720.0L - q * (1.0L / 40320.0L))));
    const auto [sine, cosine] = of_anchor_;
    return {sine + (cosine * s - sine * v), cosine - (sine * s + cosine * v)};
  }

 private:
  long double anchor_ = 0.0L;
  Sines of_anchor_{0.0L, 1.0L};
};

}  // namespace brachisto::math
