// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The closed form: the centre of an axisymmetric body runs on a cycloid.

#pragma once

#include <optional>

#include "brachisto/model/scene.hpp"
#include "model/contact.hpp"

namespace brachisto {

/// An arc of a cycloid that starts at a cusp,
///
///     x = x_0 + a (ψ − sin ψ),  z = z_0 + a (1 − cos ψ),  0 ≤ ψ ≤ ψ_end,
///
/// with slope angle β = π/2 − ψ/2, arc length s = 4 a (1 − cos ψ/2) and, for a
/// bead, ψ = t √(g/a): ψ is proportional to time, and to the rolling time u of
/// any axisymmetric body.
struct CycloidArc {
  Point start;           ///< (x_0, z_0) [m]
  double a = 0.0;        ///< radius of the generating circle [m]
  double psi_end = 0.0;  ///< in (0, 2π) [rad]

  [[nodiscard]] Point at(double psi) const;
  [[nodiscard]] double slope_angle(double psi) const;  ///< [rad]
  [[nodiscard]] double arc_length(double psi) const;   ///< from the cusp [m]
  /// U = ψ_end √(a/g), the rolling time of the whole arc [s].
  [[nodiscard]] double rolling_time(double gravity) const;
  /// w = √(2 g (z − z_0)) [m/s].
  [[nodiscard]] double fall_speed(double gravity, double psi) const;
};

/// The arc from a cusp at `start` through `end`; nothing unless `end` lies to
/// the right of and below `start`.
[[nodiscard]] std::optional<CycloidArc> cycloid_between(Point start, Point end);

/// The path of the centre that an axisymmetric body (η = 0) of the scene's
/// radius takes: cusp above A where the track is vertical, at (r, 0), and end
/// slope φ equal to the slope with which C_B(φ) was built.
///
/// With 2 a cos²φ = H − r cos φ eliminated, φ is the root in (−π/2, π/2) of
///
///     (H − r cos φ)(π − 2φ − sin 2φ) − 2 cos²φ (L − r + r sin φ) = 0.
///
/// The transit time is U √(1 + k). There is a root, and then only one, iff
/// (L − r)² + H² > r², that is unless B lies inside the body at its start. With
/// Contact::Centre this is the cycloid from A to B.
[[nodiscard]] std::optional<CycloidArc> axisymmetric_optimum(
    const Scene& scene);

}  // namespace brachisto
