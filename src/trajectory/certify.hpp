// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The checks of solutions and of motions on given paths.

#pragma once

#include "brachisto/trajectory/motion.hpp"
#include "transcription/extremal_curve.hpp"
#include "transcription/rolling_time.hpp"

namespace brachisto {

/// Thresholds of the checks, each for a number without unit: lengths in units
/// of max(L, H), speeds of √(2 g max(L, H)).
struct CertificateThresholds {
  /// The solver's default tolerance is 1e-12; a residual ε changes τ by about
  /// ε times the sum of multipliers, so 1e-9 keeps eight digits at the worst.
  double kkt_residual = 1e-9;
  double defects = 1e-9;
  double contact_error = 1e-9;
  /// τ changes by r √A / w per radian of mismatch.
  double tangency = 1e-8;
  /// What is measured between nodes has order p + 1 or, for slopes, p, while T
  /// has order 2p: for a relative error ε of T that makes ε^((p+1)/2p) and
  /// ε^(1/2). The factor allows for the constants, which are of order one to
  /// ten in the cases of the paper.
  double interior_factor = 100.0;
  /// The time T' of the path itself exceeds T by the square of the path's
  /// error, the solution's T_h errs by ε: |T' − T_h| ≤ ε T up to higher orders,
  /// found to be below 0.8 ε T on all meshes down to two elements per turn.
  double time_factor = 3.0;
  /// However large ε is: what is off by more is no picture of a path. The
  /// coarsest meshes that get T right to 1 % have 0.2 for 𝓗, 0.6 for slopes,
  /// which are constant in an element then, and 0.03 for the motion.
  double largest_interior = 0.25;
  double largest_slope = 0.7;
  double largest_at_end = 0.1;
  /// Some rounding of 𝓗, whose terms are of order one.
  double weierstrass = 1e-12;
};

/// Tests a solution of `problem` found with the end angle φ, by code that
/// shares only the physics with the optimiser.
///
/// Optimality:
///   kkt_residual     stationarity, in long double and by other derivatives
///   hamiltonian      max |𝓗| / √A between nodes; zero on an extremal
///   slope            max |∂𝓗/∂β| / √A of the interpolated slopes
///   start_angle      slope of the curve at the start against β₀, from rest
///   closure_at_A     the same against the slope that the start was built from,
///                    with an initial speed
///   turning_costate  in the field of a sphere, where p_x and p_z vary: the one
///                    of turning about its centre, which does not
///   second_order     eigenvalues of the KKT matrix with the wrong sign or none
///   legendre         −min ∂²𝓗/∂β²; below zero on a minimum
///   weierstrass      max (𝓗(β) − 𝓗(b)) / √A over all directions b; zero, at
///                    b = β, if none is better
/// Integrity:
///   defects          equality constraints, in long double
///   contact_error    distance of the track's ends from A and B
///   closure           |β_end(φ) − φ|, for Contact::Smooth
///   energy_drift     max |w²/2g − E| at element ends, in other worlds of
///                    ½ w² + Φ and the work of the drag, over g
///   reintegrated_time  T of the motion from the equation of motion against T,
///                    to one and the same end point
///   reintegration_error  of that motion the largest relative error of T and
///   end
///                    speed, and of end position and θ
///   slope_angle      continuous slope angle within [−π, π]: no loop
///   speed            share of the places after the start without w > 0
///
/// \param curve  of that solution
/// \param error  relative error of T that the solution has or may have; the
///               thresholds between nodes follow from it
[[nodiscard]] Certificate certify(RollingTime& problem, const PrimalDual& point,
                                  const ExtremalCurve& curve, double phi,
                                  double error);
/// The same where the curve is not at hand.
[[nodiscard]] Certificate certify(RollingTime& problem, const PrimalDual& point,
                                  double phi, double error);

class ArcLength;
class ArcLengthMotion;

/// The same for an arc_length problem. Checks are those above where they have a
/// meaning here:
///
/// Optimality:
///   kkt_residual     stationarity, in long double and by other derivatives
///   legendre, weierstrass  of 𝓗 on the pieces: no other direction is better
///   start_angle      slope of the curve through the nodes at the start
///   second_order     eigenvalues of the KKT matrix with the wrong sign or none
/// Integrity:
///   defects          equality constraints, in long double
///   contact_error    of the path's fixed end from C_B(φ), and of the curve
///   closure           |β_end(φ) − φ|, for Contact::Smooth
///   slope_angle      continuous slope angle of the pieces within [−π, π]
///   reintegrated_time  time on the curve through the nodes against T
///   reintegration_error  the equation of motion on that curve, integrated in
///                    time: place and speed at the end
///
/// \param error  relative error of T that the solution has or may have
[[nodiscard]] Certificate certify(ArcLength& problem, const PrimalDual& point,
                                  double phi, const ArcLengthMotion& motion,
                                  double error);

class PrescribedMotion;

/// Tests a motion that arrived.
///
///   quadrature_error     what the last halving of the cells changed in T
///   contact_error        distance of the ends of the track, or of the centre's
///                        path, from A and B, in units of L and H
///   energy_drift         in other worlds than the ordinary one, what ½ w² has
///                        gained against the work of the field's force or, in
///                        air, the fall of the potential less the work of the
///                        drag, over ½ w² or g H
///   reintegration_error  the motion integrated again
///
/// \param tolerance  wanted relative error of T
[[nodiscard]] Certificate certify_path(const PrescribedMotion& motion,
                                       double tolerance);

class LimitedCurve;

/// Tests a solution under limits.
///
/// Optimality:
///   kkt_residual, complementarity, multiplier_signs  of the finite problem
///   second_order     eigenvalues of the KKT matrix with the wrong sign or
///                    none, limits that hold being equations
/// Integrity:
///   defects          equality constraints and bounds
///   limits           by how much a limit is exceeded between nodes
///   contact_error    distance of the track's ends from A and B
///   closure          of the slopes that the ends were built from; of a path
///                    without arcs, whose track ends with its own slope, 0
///   slope_angle      continuous slope angle within [−π, π]: no loop
///   reintegration_error  the equation of motion along the path
///   reintegrated_limits  by how much that motion exceeds a limit
///
/// \param mismatch  of the slopes at the contacts, the larger one [rad]
/// \param error     relative error of T that the solution has or may have
[[nodiscard]] Certificate certify(const LimitedCurve& curve, double mismatch,
                                  double error);

}  // namespace brachisto
