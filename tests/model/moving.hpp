// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A moving body as Newton's and Euler's laws have it.

#pragma once

#include "model/field.hpp"
#include "model/path_inequality.hpp"

namespace brachisto::testing {

struct Moving {
  double theta, beta, v, turning;  ///< dβ/dt
};

/// The state W and its q = dβ/du of what moves so.
[[nodiscard]] inline TurningPoint<double> state_of(const Scene& scene,
                                                   const Moving& at) {
  const double root = root_of_inertia(scene, at.theta, at.beta);
  return {0.0, 0.0, at.theta, at.v * root, at.beta, at.turning * root};
}

}  // namespace brachisto::testing
