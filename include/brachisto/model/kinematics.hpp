// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Speeds, forces and curvatures of a rolling body from its place on a path,
/// and their limits as it leaves its place of rest.

#pragma once

#include "brachisto/model/body.hpp"
#include "brachisto/model/scene.hpp"

namespace brachisto {

/// What the motion at one place of a path is determined by, in any units.
struct PathState {
  Point centre;            ///< (x_c, z_c)
  double theta = 0.0;      ///< θ [rad]
  double beta = 0.0;       ///< slope angle β [rad]
  double w = 0.0;          ///< √(2 g E); with losses the state in its place
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

/// κ_c in the unit of kappa_b, positive where the centre's path turns
/// downwards; of a bead that of its track. Where r κ_c is small, digits beyond
/// those of fold_margin are lost.
[[nodiscard]] double curvature_of_centre(const Body& body,
                                         const Kinematics& motion);

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

/// The same in any world: with the field G at the centre of mass in place of
/// (0, g), and less the drag on the centre, which is no force of the track, and
/// what losses take.
/// Forces stay in m g, g being the scene's.
[[nodiscard]] Kinematics kinematics(const Scene& scene, const PathState& state);

/// What tends to a limit as u → 0 and is not defined, or says nothing, at the
/// start itself.
struct StartLimits {
  double normal_force = 0.0;       ///< R_n [m g]
  double normal_force_rate = 0.0;  ///< dR_n/du [1/s]; 0 where R_n ≠ 0
  double curvature = 0.0;    ///< κ_b of the track [1/m]; −∞ for a bead
  double fold_margin = 1.0;  ///< 1 − r κ_c; ±∞ if κ_c is not finite

  /// The body leaves its track at once: R_n < 0 there, or it falls from 0.
  [[nodiscard]] bool lifts_off() const {
    return normal_force < 0.0 || normal_force_rate < 0.0;
  }
};

/// The limits on a path that leaves with the slope angle β₀ and dβ/du = β′ ≠ 0
/// there, so that κ_c = β′/w is infinite. With F = A cos β₀ − a η cos δ,
/// δ = θ_m − β₀, q = 1 − η sin δ and g = `gravity`,
///
///     R_n = F/A,   κ_b = −1/r (bead: ±∞),   1 − r κ_c = ∓∞ for β′ ≷ 0,
///     dR_n/du = −(β′/A)(2 q sin β₀ + k a/q)   where F = 0,
///
/// as it is on every extremal. The parenthesis is positive, so that next to the
/// start not to lift off and not to fold are the same: β′ < 0. F counts as zero
/// if it is no more than its rounding.
///
/// \param beta_rate  β′ [rad/s]
[[nodiscard]] StartLimits start_limits(const Body& body, double beta_0,
                                       double beta_rate);

/// The same in any world. With an initial speed nothing is singular, and they
/// are the values there. From rest the field's direction at the centre of mass
/// takes the place of the vertical and its strength that of g; linear drag,
/// which grows with the speed, adds η c₁ a cos δ/A^(3/2) to dR_n/du.
///
/// \param start  where the motion begins, with dβ/du there
[[nodiscard]] StartLimits start_limits(const Scene& scene,
                                       const PathState& start);

/// The same on a path whose curvature κ_c [1/m] is finite there, β′ = 0.
[[nodiscard]] StartLimits start_limits_of_curvature(const Scene& scene,
                                                    const PathState& start,
                                                    double kappa_c);

}  // namespace brachisto
