// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Speeds, forces and curvatures of a rolling body from its place on a path.

#pragma once

#include "brachisto/model/contact.hpp"
#include "brachisto/model/scene.hpp"

namespace brachisto {

/// What the motion at one place of a path is determined by, in any units.
struct PathState {
  Point centre;            ///< (x_c, z_c)
  double theta = 0.0;      ///< θ [rad]
  double beta = 0.0;       ///< slope angle β [rad]
  double w = 0.0;          ///< √(2 g E)
  double beta_rate = 0.0;  ///< dβ/du, u the rolling time: dt = √A du
};

/// Motion at that place, in the same units; forces in m g.
struct Kinematics {
  Point mass_centre;     ///< (x_cm, z_cm), eqs. (2)–(3)
  Point contact;         ///< (x_b, z_b), eqs. (11)–(12)
  double v_c = 0.0;      ///< speed of the centre
  double omega = 0.0;    ///< ω = v_c / r; 0 for a bead
  double R_n = 0.0;      ///< normal force / (m g), eqs. (20)–(22)
  double R_t = 0.0;      ///< tangential force / (m g), along the motion
  double kappa_b = 0.0;  ///< curvature of the track, eq. (23), positive where
                         ///< it turns downwards
  double fold_margin = 1.0;  ///< 1 − r κ_c, positive where the track does not
                             ///< fold
};

/// All of Kinematics. With κ_c = dβ/ds = β_u / w the centre accelerates with
///
///     v̇ t + w β_u / A n_⊥,   v̇ = g a / A − w A_u / (2 A²),
///     A_u = −2 η cos(θ − β)(w/r − β_u),   t = (cos β, sin β), n_⊥ = dt/dβ,
///
/// written without κ_c so that nothing is singular at the start, where w = 0.
/// Only kappa_b and fold_margin refer to κ_c; at w = 0 they are its limits, for
/// a cylinder −1/r and +∞ if β_u < 0 there.
[[nodiscard]] Kinematics kinematics(const Body& body, double gravity,
                                    const PathState& state);

}  // namespace brachisto
