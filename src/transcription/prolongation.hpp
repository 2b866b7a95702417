// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A solution of one mesh as the start of a solve on another.

#pragma once

#include <functional>

#include "brachisto/nlp/problem.hpp"
#include "transcription/arc_length.hpp"
#include "transcription/extremal_curve.hpp"

namespace brachisto {

/// States, slopes and multipliers of `curve` at the nodes and collocation
/// points of `problem`, whose scene has a body of the same kind. Multipliers
/// go along as λ_j = −b_j p(σ_j); a start without them would be a cold one.
[[nodiscard]] PrimalDual prolong(const ExtremalCurve& curve,
                                 const RollingTime& problem);

/// The same for states, slopes and costates given as a function of σ ∈ [0, 1],
/// in the units of the problem's scene; s and t are not used.
[[nodiscard]] PrimalDual sample_at_mesh(
    const RollingTime& problem, double rolling_time,
    const std::function<ExtremalPoint(double sigma)>& extremal);

/// Nodes of `problem` on an extremal of its scene, at the lengths S σ_j²;
/// multipliers from its costates p_x, p_z. The problem is moved there.
[[nodiscard]] PrimalDual prolong(const ExtremalCurve& curve,
                                 ArcLength& problem);

/// The solution of a mesh as the start on another one of the same scene, with
/// multipliers: (x, z)/σ² less its value at the start, over σ, is interpolated
/// by cubics in σ, θ follows from S, and the multipliers are those that belong
/// to the costates at the end. Both problems are moved.
///
/// \param coarse  of four pieces or more
[[nodiscard]] PrimalDual prolong(ArcLength& coarse, const PrimalDual& solution,
                                 ArcLength& fine);

}  // namespace brachisto
