// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The equation of motion of a body on a given path, in any world.

#pragma once

#include "brachisto/model/scene.hpp"
#include "trajectory/path_by_place.hpp"

namespace brachisto {

/// s̈ where the centre has come the length s and is at a place, by
///
///     A s̈ = G·(cos β − η sin θ, sin β + η cos θ) − D − ½ A_s ṡ²,
///     A_s = −2 η cos(θ − β) (1/r − κ_c),
///
/// with the field G at the centre of mass and the drag D on the centre: in a
/// uniform field without air g (sin β + η cos θ) − ½ A_s ṡ². Neither energy nor
/// the rolling time enter.
///
/// \param place    without effect in a uniform field
/// \param v        ṡ
/// \param v_kappa  ṡ κ_c
[[nodiscard]] double acceleration(const Scene& scene, double s, double v,
                                  Point place, const Direction& along,
                                  double v_kappa);

/// dθ/ds.
[[nodiscard]] double rotation_per_length(const Body& body);

}  // namespace brachisto
