// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of an arc_length solution beyond the solver's word.

#pragma once

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/trajectory/arc_length_motion.hpp"
#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/transcription/arc_length.hpp"

namespace brachisto {

/// Tests a solution of `problem` found with the end angle φ. Checks are those
/// of certify() where they have a meaning here:
///
/// Optimality:
///   kkt_residual     stationarity, in long double and by other derivatives
///   legendre, weierstrass  of 𝓗 on the pieces: no other direction is better
///   start_angle      slope of the curve through the nodes at the start
///   second_order     eigenvalues of the KKT matrix with the wrong sign or none
/// Integrity:
///   defects          equality constraints, in long double
///   contact_error    of the path's fixed end from C_B(φ), and of the curve
///   closure          |β_end(φ) − φ|, for Contact::Smooth
///   slope_angle      continuous slope angle of the pieces within [−π, π]
///   reintegrated_time  time on the curve through the nodes against T
///   reintegration_error  the equation of motion on that curve, integrated in
///                    time: place and speed at the end
///
/// \param error  relative error of T that the solution has or may have
[[nodiscard]] Certificate certify(ArcLength& problem, const PrimalDual& point,
                                  double phi, const ArcLengthMotion& motion,
                                  double error,
                                  const CertificateThresholds& thresholds = {});

}  // namespace brachisto
