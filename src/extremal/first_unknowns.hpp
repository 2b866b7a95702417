// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From a guess in SI units to unknowns of the shooting equations in natural
/// units, their number and their scale.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "brachisto/model/units.hpp"
#include "extremal/shooting_system.hpp"

namespace brachisto::shooting {

/// Number of arcs: `wanted`, or if that is 0 three for each turn of the body,
/// the natural length of all that varies along the path, but at least four.
[[nodiscard]] int choose_arcs(const Scene& natural, const ExtremalGuess& guess,
                              int wanted);

/// The guess where arcs meet. θ of a bead counts arc length, on which nothing
/// depends: it is left at zero here, and Newton's first step corrects it.
[[nodiscard]] ChainVector to_chain(const Scene& natural, const Units& units,
                                   const ExtremalGuess& guess, int num_arcs);

/// Natural sizes: those of the guess for U and (p_x, p_z), r for p_θ (which is
/// r times a costate of arc length), 1 for lengths, speeds and angles.
[[nodiscard]] ChainScale scale_of(const Scene& natural,
                                  const ChainVector& point);

}  // namespace brachisto::shooting
