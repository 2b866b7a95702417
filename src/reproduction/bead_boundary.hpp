// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which cylinders are faster than the bead.

#pragma once

#include <vector>

#include "brachisto/model/scene.hpp"

namespace brachisto::reproduction {

/// A body of the boundary: with more inertia it is slower than the bead.
struct BoundaryBody {
  double eta_m = 0.0;
  double k = 0.0;
  double theta_m = 0.0;  ///< [rad]
  bool on_rim = false;  ///< k is the largest one possible, 1 − η_m², and the
                        ///< body still faster
};

/// For each η_m the k at which the fastest times of both are equal.
///
/// \param scene  radius, L, H and, if `best` is false, θ_m of the cylinders
/// \param best   each body put down as fastest_orientation() says
[[nodiscard]] std::vector<BoundaryBody> bead_boundary(
    const Scene& scene, const std::vector<double>& eta_m, bool best);

}  // namespace brachisto::reproduction
