// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The indirect method in another world.

#pragma once

#include "extremal/shooting.hpp"

namespace brachisto {

/// solve_extremal() of a scene whose world is not ordinary, by Newton's method
/// for the equations of arcs::ArcSystem from a guess nearby.
[[nodiscard]] ExtremalSolution solve_extremal_in_world(
    const Scene& scene, const ExtremalGuess& guess,
    const ExtremalOptions& options);

/// The same on the principal branch, followed from the extremal of the ordinary
/// world.
/// \param ordinary  usable(), of in_ordinary_world(scene)
[[nodiscard]] ExtremalSolution solve_extremal_in_world(
    const Scene& scene, const ExtremalSolution& ordinary,
    const ExtremalOptions& options);

}  // namespace brachisto
