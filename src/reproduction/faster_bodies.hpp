// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How a body is best put down, and which cylinders are faster than the bead.

#pragma once

#include <vector>

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

/// A body of the boundary: with more inertia it is slower than the bead.
struct BoundaryBody {
  double eta_m = 0.0;
  double k = 0.0;
  Measured theta_m;  ///< [rad]; its error is 0 where it is given

  /// False with the centre of mass on the axis, where θ_m says nothing.
  [[nodiscard]] bool has_orientation() const { return eta_m > 0.0; }
};

/// For each η_m the k at which both take the same time, each on its extremal,
/// as long as that is possible, k ≤ 1 − η_m²; then the body on the rim, k = 1 −
/// η_m², with which the boundary ends.
///
/// \param scene  radius, L, H and, if `best` is false, θ_m of the cylinders
/// \param eta_m  ascending, the last one beyond that end
/// \param best   each body put down as fastest_orientation() says
/// \throws Interrupted, NotVerified  also if the boundary does not end in time
[[nodiscard]] std::vector<BoundaryBody> bead_boundary(
    const Scene& scene, const std::vector<double>& eta_m, bool best,
    const Interrupt& interrupt);

}  // namespace brachisto::reproduction
