// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far a discrete solution is from the extremal, and where.

#pragma once

#include <vector>

#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// Share of each element in the error of T between the given end points.
///
/// Between collocation points the Hamiltonian of a discrete solution is not
/// zero, and its integral is the error: with exact end points
///
///     T − T_h = U ∫₀¹ 𝓗(x_h, p_h, β_h) dσ + O(h^(2p+2)).
///
/// For the continuous Lagrangian U ∫ 𝓗 dσ − ∫ p·x' dσ is stationary at the
/// extremal, where it is T; at the discrete solution it differs from T only by
/// the square of the error between nodes. The discrete solution makes the same
/// expression stationary with Gauss's rule in place of the integrals, which is
/// exact for p·x' and gives zero for 𝓗, so that T_h = −∫ p_h·x_h' dσ.
///
/// The sum of Gauss's rule is zero over the whole path but not over an element;
/// taking it off each share leaves the total as it is and the shares free of a
/// drift that belongs to no element.
///
/// \return U (∫_e 𝓗 dσ − h_e Σ_j b_j 𝓗_j) of each element, with signs, in the
///         units of the curve
[[nodiscard]] std::vector<double> element_errors(const ExtremalCurve& curve);

}  // namespace brachisto
