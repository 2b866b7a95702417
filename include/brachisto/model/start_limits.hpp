// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Forces and curvatures as a body leaves its place of rest.

#pragma once

#include "brachisto/model/body.hpp"

namespace brachisto {

/// What tends to a limit as u → 0 and is not defined, or says nothing, at the
/// start itself.
struct StartLimits {
  double normal_force = 0.0;       ///< R_n [m g]
  double normal_force_rate = 0.0;  ///< dR_n/du [1/s]; 0 where R_n ≠ 0
  double curvature = 0.0;    ///< κ_b of the track [1/m]; −∞ for a bead
  double fold_margin = 1.0;  ///< 1 − r κ_c; ±∞ if κ_c is not finite

  /// The body leaves its track at once: R_n < 0 there, or it falls from 0.
  [[nodiscard]] bool lifts_off() const {
    return normal_force < 0.0 || normal_force_rate < 0.0;
  }
};

/// The limits on a path that leaves with the slope angle β₀ and dβ/du = β′ ≠ 0
/// there, so that κ_c = β′/w is infinite. With F = A cos β₀ − a η cos δ,
/// δ = θ_m − β₀, q = 1 − η sin δ and g = `gravity`,
///
///     R_n = F/A,   κ_b = −1/r (bead: ±∞),   1 − r κ_c = ∓∞ for β′ ≷ 0,
///     dR_n/du = −(β′/A)(2 q sin β₀ + k a/q)   where F = 0,
///
/// as it is on every extremal. The parenthesis is positive, so that next to the
/// start not to lift off and not to fold are the same: β′ < 0. F counts as zero
/// if it is no more than its rounding.
///
/// \param beta_rate  β′ [rad/s]
[[nodiscard]] StartLimits start_limits(const Body& body, double beta_0,
                                       double beta_rate);

/// The same on a path whose curvature κ_c [1/m] is finite there, β′ = 0.
[[nodiscard]] StartLimits start_limits_of_curvature(const Body& body,
                                                    double beta_0,
                                                    double kappa_c);

}  // namespace brachisto
