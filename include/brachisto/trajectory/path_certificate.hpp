// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of the motion on a given path beyond its quadrature.

#pragma once

#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/prescribed_motion.hpp"

namespace brachisto {

/// The equation of motion, A s̈ = g (sin β + η cos θ) − ½ A_s ṡ², integrated in
/// time on the path of a motion that arrived: where the body is at T, as a
/// relative error of T, or its end speed, whichever is worse. NaN if it fails.
///
/// \param from  the place q where it begins with the speed that energy gives;
///              0: at rest. Where the curvature is infinite at the start the
///              right-hand side is not smooth next to it.
[[nodiscard]] double reintegration_error(const PrescribedMotion& motion,
                                         double from = 0.0);

/// Tests a motion that arrived.
///
///   quadrature_error     what the last halving of the cells changed in T
///   contact_error        distance of the ends of the track, or of the centre's
///                        path, from A and B, in units of max(L, H)
///   reintegration_error  the motion integrated again
///
/// \param tolerance  wanted relative error of T
[[nodiscard]] Certificate certify_path(const PrescribedMotion& motion,
                                       double tolerance);

}  // namespace brachisto
