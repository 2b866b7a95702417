// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What is known of the motion on a given path beyond its quadrature.

#pragma once

#include "brachisto/trajectory/certificate.hpp"
#include "brachisto/trajectory/prescribed_motion.hpp"

namespace brachisto {

/// Tests a motion that arrived.
///
///   quadrature_error     what the last halving of the cells changed in T
///   contact_error        distance of the ends of the track, or of the centre's
///                        path, from A and B, in units of max(L, H)
///   reintegration_error  the equation of motion, A s̈ = g (sin β + η cos θ) −
///                        ½ A_s ṡ², integrated in time: where the body is at T,
///                        as a relative error of T, and its end speed
///
/// \param tolerance  wanted relative error of T
[[nodiscard]] Certificate certify_path(const PrescribedMotion& motion,
                                       double tolerance);

}  // namespace brachisto
