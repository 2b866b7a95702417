// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where the centre starts and ends, given where the body touches the track.

#pragma once

#include "brachisto/model/body.hpp"
#include "brachisto/model/scene.hpp"

namespace brachisto {

/// Centre of a body of the given radius that touches the track at `contact`,
/// where the track has slope angle β: eqs. (11)–(12) solved for (x_c, z_c).
[[nodiscard]] Point centre_above(Point contact, double radius, double beta);

/// Point of the track under a centre, eqs. (11)–(12).
[[nodiscard]] Point track_below(Point centre, double radius, double beta);

/// The radius by which centre and track are apart at A and B: 0 where these
/// are ends of the centre's path itself.
[[nodiscard]] inline double contact_radius(const Scene& scene) {
  return scene.contact == Contact::Centre ? 0.0 : scene.body.radius;
}

/// C_A, where the centre starts [m]: above A with the start angle β₀, or A
/// itself with Contact::Centre.
[[nodiscard]] Point start_of_centre(const Scene& scene);

/// d/dα of the start that is built from the slope α at A.
struct StartRates {
  double x = 0.0, z = 0.0;  ///< of C_A: r (cos α, sin α), or 0 at A itself
  double w = 0.0;  ///< of v₀ √A(θ_m, α): v₀ η cos(θ_m − α)/√A
};
[[nodiscard]] StartRates start_rates(const Scene& scene);

/// C_B(φ), where the centre ends if the track has slope angle φ at B [m].
/// With Contact::Centre it is B and does not depend on φ.
[[nodiscard]] Point end_of_centre(const Scene& scene, double phi);

}  // namespace brachisto
