// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the paper leaves open in its discrete system.

#pragma once

namespace brachisto {

/// Both ends and a node to move.
inline constexpr int kFewestDiscreteNodes = 3;
/// Of DiscreteReading::epsilon.
inline constexpr double kLargestEpsilon = 0.1;

/// A reading of section "Solution Methodology": the choices that eqs. (13)–(19)
/// need and the paper does not state, and its ε.
struct DiscreteReading {
  /// Transit time of a chord of length l with speeds v at its ends.
  enum class Quadrature {
    MeanSpeed,  ///< 2 l / (v_left + v_right); the only one regular at a start
                ///< from rest, of first order there
    Midpoint,   ///< l / v with E and θ halfway; error n^(−1/2) at the start
    Trapezoid,  ///< l (1/v_left + 1/v_right) / 2; MeanSpeed where v_left = 0
  };
  /// What the energy height E of eq. (1) is measured from.
  enum class Datum {
    Release,  ///< z − z_1: at rest at node 1, whatever the slope there
    Rest,     ///< z as printed, but v = 0 at node 1
    Printed,  ///< z as printed: E_1 = −r cos β_1, negative unless the first
              ///< chord is vertical, and then v_1 is no real number
  };
  /// sin and cos of the end slopes.
  enum class Slopes {
    Literal,  ///< z'/√(1 + z'²) and 1/√(1 + z'²) with z' = Δz/Δx, as printed:
              ///< they jump where Δx changes its sign
    Smooth,  ///< Δz/l and Δx/l, the same where Δx > 0
  };

  Quadrature quadrature = Quadrature::MeanSpeed;
  Datum datum = Datum::Release;
  Slopes slopes = Slopes::Literal;
  /// Half width of the central differences of eq. (18), in units of H, at
  /// most kLargestEpsilon; 0 takes their limit, the exact derivatives.
  double epsilon = 1e-3;
};

}  // namespace brachisto
