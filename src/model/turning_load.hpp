// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The load that a small body's own mass makes as it turns.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "model/contact.hpp"
#include "model/inertia.hpp"
#include "model/path_inequality.hpp"

namespace brachisto {

/// The bounds that limits set to R_n and to the centre's curvature.
struct LoadBounds {
  static constexpr double kNone = std::numeric_limits<double>::infinity();
  double least = -kNone, most = kNone;  ///< R_n
  double hump = kNone, valley = kNone;

  explicit LoadBounds(const std::vector<PathInequality>& limits) {
    using Kind = PathInequality::Kind;
    for (const PathInequality& limit : limits) {
      if (limit.kind == Kind::Hump) hump = std::min(hump, limit.number);
      if (limit.kind == Kind::Valley) valley = std::min(valley, limit.number);
      if (limit.kind == Kind::NormalForce) {
        least = std::max(least, limit.lower);
        most = std::min(most, limit.upper);
      } else if (limit.bounds_force()) {
        // Of friction: the sum of its two rows, 2 μ R_n.
        least = std::max(least, limit.lower / limit.number);
      }
    }
  }
};

/// The part of R_n that is due to speed, at least, where the mass is next to
/// the track (side 1) or furthest from it (side −1), away from the track there:
/// at δ = θ − β = ±π/2, in a field of gravity alone,
///
///     R_n = cos β ± (2E/A)(η/r ∓ κ),   A = (1 ∓ η)² + k,
///
/// with κ > 0 on humps. With sin θ = ± cos β the height E is at least
/// drop − r η (1 + sin θ_m).
///
/// Nothing can be said, −∞, where the track may bend enough to take it away.
///
/// \param drop  z − z_0 of the centre, at least [m]
/// \param bend  the largest curvature that takes some of it away [1/m]
[[nodiscard]] inline double turning_load(const Body& body, double side,
                                         double drop, double bend) {
  const double left = body.eta_m / body.radius - bend;
  if (!(left > 0.0)) return -LoadBounds::kNone;
  const double E =
      drop - body.radius * body.eta_m * (1.0 + std::sin(body.theta_m));
  const double A = inertia_factor(body, side * 0.5 * std::numbers::pi, 0.0);
  return 2.0 / A * std::max(0.0, E) * left;
}

/// False only if no path without a loop keeps the limits of load: on its last
/// length of 4 π r the body turns by 4 π and the path by 2 π at most, so that
/// its mass comes next to the track, and furthest from it. There the centre is
/// at most that length above its end, which is at least H − 2 r below its
/// start (H between centres), and so fast that the load is beyond a bound
/// wherever the track may bend.
[[nodiscard]] inline bool can_bear_turns(
    const Scene& scene, const std::vector<PathInequality>& limits) {
  const Body& body = scene.body;
  if (!body.off_centred() || !scene.world.ordinary()) return true;
  const double drop = scene.H - 2.0 * contact_radius(scene) -
                      4.0 * std::numbers::pi * body.radius;
  if (!(drop > 0.0)) return true;  // it may be there before it has turned
  const LoadBounds bounds(limits);
  return 1.0 - turning_load(body, -1.0, drop, bounds.valley) >= bounds.least &&
         turning_load(body, 1.0, drop, bounds.hump) - 1.0 <= bounds.most;
}

/// What to say where it cannot.
inline constexpr std::string_view kTurnsTooFast =
    "no path without a loop leads to B under these limits: in the last turns "
    "before it the body's own mass, which is off its centre, loads the track "
    "more than the limits allow or lifts it off, however the track bends "
    "within them";

}  // namespace brachisto
