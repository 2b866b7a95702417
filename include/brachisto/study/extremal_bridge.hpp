// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Between collocation and the indirect method.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/model/units.hpp"
#include "brachisto/transcription/extremal_curve.hpp"

namespace brachisto {

/// A collocation solution, in natural units, as the start of a shooting.
/// \param curve  must outlive the guess
[[nodiscard]] ExtremalGuess as_guess(const ExtremalCurve& curve,
                                     const Units& units, double phi);

/// An extremal, in SI units, as unknowns and multipliers of a collocation
/// problem in natural units.
[[nodiscard]] PrimalDual sample_extremal(const ExtremalSolution& extremal,
                                         const Units& units,
                                         const RollingTime& problem);

}  // namespace brachisto
