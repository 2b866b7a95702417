// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The direction of the start under limits.

#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "model/contact.hpp"
#include "model/path_inequality.hpp"

namespace brachisto {

/// The body at rest at A on a slope β, which says where its centre is.
template <class Scalar>
[[nodiscard]] TurningPoint<Scalar> resting_at(const Scene& scene,
                                              const Scalar& beta) {
  using std::cos;
  using std::sin;
  const double r = contact_radius(scene);
  return {sin(beta) * r, cos(beta) * -r, Scalar(scene.body.theta_m),
          Scalar(0.0),   beta,           Scalar(0.0)};
}

/// The slope angle at rest of the largest growth of speed, a²/A, among those
/// with a > 0 at which friction and normal force keep their limits: at rest
/// both are independent of the curvature, and the directions that are left are
/// the static cone. Nothing if it is empty.
[[nodiscard]] std::optional<double> start_angle_under(
    const Scene& scene, const std::vector<PathInequality>& limits);

/// The same where a path has to begin with it; nothing where its start slope is
/// a matter of the whole path.
[[nodiscard]] std::optional<double> known_start_slope(
    const Scene& scene, const std::vector<PathInequality>& limits);

}  // namespace brachisto
