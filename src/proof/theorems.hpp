// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is shown of an extremal once it is known to exist.

#pragma once

#include <string>

#include "proof/root.hpp"

namespace brachisto::proof {

/// A statement, or why it is not shown.
struct Theorem {
  bool holds = false;
  std::string why_not = {};
};

/// Numbers of the extremal, enclosed: without dimension and in radians.
struct Enclosures {
  Real tau;          ///< T √(2 g/H)
  Real start_angle;  ///< β₀
  Real end_angle;    ///< φ
  Real length;       ///< S/H
  Real rotation;     ///< θ − θ_m at the end
};

/// All that is shown.
struct Theorems {
  Enclosures enclosed;
  /// h_ββ > 0 and no point conjugate to the end: a strict weak local minimum
  /// between its fixed ends.
  Theorem legendre, no_conjugate_point;
  Theorem presses;  ///< R_n > 0 on (0, U]
  Theorem no_fold;  ///< r κ_c < 1 on (0, U]
  Theorem no_loop;  ///< −π < β < π

  [[nodiscard]] bool strict_minimum() const {
    return legendre.holds && no_conjugate_point.holds;
  }
};

/// \param root  the extremal, of which that it exists is shown
/// \throws NotProven  if its motion cannot be enclosed
[[nodiscard]] Theorems prove_theorems(const Scene& scene, const Root& root,
                                      const Accuracy& accuracy);

/// Whether no point of the extremal but its end is conjugate to that.
///
/// In the coordinates (x, θ, w), where the motion is regular from rest on and z
/// follows from the energy, all extremals that end in (x_B, z_B) with any θ,
/// p_θ = p_w = 0 and 𝓗 = 0 are a family of two parameters, θ and β at the end.
/// The determinant of its derivatives by both and by u vanishes at the end, and
/// is shown to vanish nowhere else, the start included.
///
/// \param end  the state at the end, enclosed; of its costates nothing is used
[[nodiscard]] Theorem no_conjugate_point(const Scene& scene, const State& end,
                                         const Real& length,
                                         const Accuracy& accuracy);

}  // namespace brachisto::proof
