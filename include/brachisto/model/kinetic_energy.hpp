// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Kinetic energy of a rolling body and its two parts.

#pragma once

#include "brachisto/model/body.hpp"
#include "brachisto/model/inertia.hpp"

namespace brachisto {

/// Kinetic energy as a height, that is in units of m g [m].
struct KineticEnergy {
  double translation = 0.0;  ///< ½ m v_cm², of the centre of mass
  double rotation = 0.0;     ///< ½ I_cm ω²

  [[nodiscard]] double total() const { return translation + rotation; }
};

/// Of a body whose centre moves at v_c. With v_cm² = (A − k) v_c² and
/// I_cm ω² = k m v_c² the total is A v_c² / 2g = E, the energy height.
[[nodiscard]] inline KineticEnergy kinetic_energy(const Body& body,
                                                  double gravity, double theta,
                                                  double beta, double v_c) {
  const double height = 0.5 * v_c * v_c / gravity;
  const double A = inertia_factor(body, theta, beta);
  return {(A - body.k) * height, body.k * height};
}

}  // namespace brachisto
