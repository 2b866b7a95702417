// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A scene solved from a neighbour's extremal, and not otherwise.

#pragma once

#include <memory>

#include "brachisto/study/solve.hpp"

namespace brachisto {

/// The answer as one to solve beside, if it is the end of a branch or of a path
/// under limits with its arcs; Solution::as_neighbour() does not tell those
/// that lie beyond a fold.
[[nodiscard]] std::shared_ptr<const Neighbour> neighbour_of(
    const Solution& solution);

/// solve(), but that the answer is on the neighbour's branch or there is none:
/// nothing is tried from the cycloid.
/// \pre hooks.neighbour can_continue() to the scene, which is_limited() not,
/// and
///      the options follow one branch
[[nodiscard]] Solution solve_beside(const Scene& scene,
                                    const SolveOptions& options,
                                    const SolveHooks& hooks);

}  // namespace brachisto
