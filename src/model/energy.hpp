// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Energy height, from which every speed follows.

#pragma once

#include <cmath>

#include "brachisto/model/body.hpp"

namespace brachisto {

/// E from what energy_height_after() makes of its `turned`, for where sines
/// and cosines are at hand.
///
/// \param drop      z − z_0 [m]
/// \param sin_half  sin (θ − θ_m)/2
/// \param cos_mean  cos (θ + θ_m)/2
template <class Scalar>
[[nodiscard]] Scalar energy_height_halfway(const Body& body, const Scalar& drop,
                                           const Scalar& sin_half,
                                           const Scalar& cos_mean) {
  return drop + cos_mean * sin_half * (2.0 * body.radius * body.eta_m);
}

/// Energy height E = z − z_0 + r η (sin θ − sin θ_m) [m]: how far the weight
/// has come down since the start (eq. (1)).
///
/// The datum z_0 is the start of the *centre*, where the body is at rest. The
/// paper prints z for z − z_0, which is the same only if the start is vertical.
///
/// The difference of sines is evaluated as 2 cos((θ + θ_m)/2) sin((θ − θ_m)/2),
/// so that E keeps its relative accuracy next to the start.
///
/// \param drop    z − z_0 [m]
/// \param turned  θ − θ_m [rad]
template <class Scalar>
[[nodiscard]] Scalar energy_height_after(const Body& body, const Scalar& drop,
                                         const Scalar& turned) {
  using std::cos;
  using std::sin;
  const Scalar half = turned * 0.5;
  return energy_height_halfway(body, drop, Scalar(sin(half)),
                               Scalar(cos(half + body.theta_m)));
}

/// The same.
///
/// \param drop   z − z_0 [m]
/// \param theta  θ [rad]
template <class Scalar>
[[nodiscard]] Scalar energy_height(const Body& body, const Scalar& drop,
                                   const Scalar& theta) {
  return energy_height_after(body, drop, Scalar(theta - body.theta_m));
}

/// The same from the sines, as eq. (1) prints it, for where they are at hand:
/// cheaper, and as accurate away from the start.
template <class Scalar>
[[nodiscard]] Scalar energy_height_from_sines(const Body& body,
                                              const Scalar& drop,
                                              const Scalar& sin_theta,
                                              double sin_theta_m) {
  return drop + (sin_theta - sin_theta_m) * (body.radius * body.eta_m);
}

/// a = sin β + η cos θ, the slope of E along the path: dE/ds [-].
template <class Scalar>
[[nodiscard]] Scalar energy_slope(const Body& body, const Scalar& theta,
                                  const Scalar& beta) {
  using std::cos;
  using std::sin;
  return sin(beta) + cos(theta) * body.eta_m;
}

/// E of a rolling body with A = A(θ, β) is half the square of w over g; w is
/// the speed of a bead that fell the height E: w = √(2 g E) [m/s].
template <class Scalar>
[[nodiscard]] Scalar fall_speed(double gravity, const Scalar& energy_height) {
  using std::sqrt;
  return sqrt(2.0 * gravity * energy_height);
}

}  // namespace brachisto
