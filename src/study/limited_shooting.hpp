// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the program under limits to the indirect method, which it tells the
/// arcs.

#pragma once

#include "brachisto/study/solution.hpp"
#include "extremal/arc_shooting.hpp"
#include "refinement/arc_fit.hpp"

namespace brachisto {

/// A solution under limits as the start of a shooting over its arcs, on each of
/// which one limit holds or none.
/// \param path  must outlive the guess
[[nodiscard]] arcs::Guess as_guess(const FittedPath& path);

/// The extremal with the arcs of a path nearby; none if two limits hold on one
/// of them.
[[nodiscard]] LimitedExtremal shoot_over_arcs(const FittedPath& path,
                                              const StopCondition& stop);

/// How that ended, the arcs being those that the program found.
[[nodiscard]] Outcome outcome_of(const LimitedExtremal& extremal);

}  // namespace brachisto
