// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Between the program under limits and the indirect method, which it tells the
/// arcs, and whose extremal has to meet its conditions to be an answer.

#pragma once

#include "brachisto/math/clock.hpp"
#include "brachisto/study/solution.hpp"
#include "extremal/arc_shooting.hpp"
#include "refinement/arc_fit.hpp"
#include "refinement/limited_refinement.hpp"

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

/// The extremal on a mesh of its arcs that is fine enough for the conditions of
/// the finite problem, which it must satisfy, to be its certificate: elements
/// are halved on which it does not, as long as that helps. States are sampled
/// and so are costates and multipliers; nothing is solved there but for what
/// the method leaves open: the multipliers along an arc that a limit on forces
/// holds from rest on or that is very short, and those of the contacts, follow
/// from stationarity.
///
/// The estimated error is what T by quadrature on the mesh and by the indirect
/// method differ by, and the error of the latter.
///
/// \param nearby    what the extremal was found from
/// \param extremal  solved
[[nodiscard]] LimitedAnswer answer_from_extremal(
    const FittedPath& nearby, const LimitedExtremal& extremal,
    const StopCondition& stop);

}  // namespace brachisto
