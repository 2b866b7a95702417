// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a solve of an arc_length problem starts.

#pragma once

#include "brachisto/nlp/primal_dual.hpp"
#include "brachisto/transcription/arc_length.hpp"
#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// Nodes of `problem` on an extremal of its scene, at the lengths S σ_j²;
/// multipliers from its costates p_x, p_z. The problem is moved there.
[[nodiscard]] PrimalDual sample(const ExtremalCurve& curve, ArcLength& problem);

/// The solution of a mesh as the start on another one of the same scene, with
/// multipliers: x/σ² and z/σ², which are smooth and not zero at the start, are
/// interpolated by cubics in σ, θ follows from S, and the multipliers are those
/// that belong to the costates at the end. Both problems are moved.
///
/// \param coarse  of four pieces or more
[[nodiscard]] PrimalDual prolong(ArcLength& coarse, const PrimalDual& solution,
                                 ArcLength& fine);

}  // namespace brachisto
