// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From the indirect method under limits back to the program, whose conditions
/// its extremal has to meet to be an answer.

#pragma once

#include "brachisto/math/clock.hpp"
#include "extremal/arc_shooting.hpp"
#include "refinement/limited_refinement.hpp"

namespace brachisto {

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
