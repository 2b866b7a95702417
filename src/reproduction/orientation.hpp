// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a body is best put down: the θ_m of the shortest transit time.

#pragma once

#include "brachisto/model/scene.hpp"
#include "reproduction/cases.hpp"

namespace brachisto::reproduction {

/// The initial orientation of a body with the smallest τ.
struct Orientation {
  Measured theta_m;  ///< [rad]
  double tau = 0.0;  ///< there
};

/// Minimises τ over θ_m near a guess.
///
/// τ is smooth in θ_m, and differences of nearly equal τ would leave half their
/// digits. So τ is interpolated at Chebyshev points of an interval that is not
/// small, and the root of the interpolant's slope taken; then once more on half
/// the interval about it. The change between both is the error.
///
/// \throws Interrupted, NotVerified  if a scene on the way has no verified
/// answer, or
///                             there is no minimum within 90° of the guess
[[nodiscard]] Orientation fastest_orientation(Scene scene, double guess,
                                              const Interrupt& interrupt);

}  // namespace brachisto::reproduction
