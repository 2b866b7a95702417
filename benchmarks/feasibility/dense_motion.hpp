// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Whether a body could run on an extremal, told without the program's forces,
/// curvatures and samples.

#pragma once

#include "transcription/extremal_curve.hpp"

namespace brachisto::benchmarks {

/// What a dense, independent evaluation sees of an extremal.
struct DenseMotion {
  /// Where the canonical equations, integrated from the start with the costates
  /// of the solution, end: distance from the solution's own end, over L + H.
  double miss = 0.0;
  double start_force_rate = 0.0;  ///< dR_n/du at u = 0 [m g per unit of u]
  double start_slope_rate = 0.0;  ///< dβ/du at u = 0
  double least_force = 0.0;       ///< of R_n over all samples behind the start
  double least_force_x = 0.0;     ///< x_b there
  /// The least step of the track along its tangent over that of the centre, at
  /// all samples: the mean of 1 − r κ_c between them.
  double least_margin = 0.0;

  [[nodiscard]] bool lifts_off() const {
    return start_force_rate < 0.0 || least_force <= 0.0;
  }
  [[nodiscard]] bool folds() const {
    return start_slope_rate > 0.0 || least_margin <= 0.0;
  }
};

/// Integrates states and costates in long double, from the start of `curve`
/// with its costates, over 10 000 samples: the slope by minimising 𝓗 anew, the
/// force on the body as the rate of its momentum by central differences, the
/// fold from where the track goes. At the start the same is done with steps of
/// U/10⁶ on both sides of u = 0, through which the equations are analytic.
/// What is shared with the program is the model's 𝓗 in words, not in code.
[[nodiscard]] DenseMotion look_densely(const ExtremalCurve& curve);

}  // namespace brachisto::benchmarks
