// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Method::Extremal: an extremal of the indirect method as an answer.

#pragma once

#include "brachisto/extremal/shooting.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// The principal extremal, through folds, by the indirect method.
/// \param tolerance  relative, of T
[[nodiscard]] ExtremalSolution shoot(const PosedProblem& posed,
                                     double tolerance);

/// How the indirect method ended.
[[nodiscard]] Outcome outcome_of(const ExtremalSolution& extremal);

/// The extremal on a mesh fine enough for the finite problem's conditions,
/// which it must satisfy, to be its certificate: elements are halved until the
/// residual passes, or no longer falls. Nothing is solved there.
///
/// The estimated error is what T by quadrature on the mesh and by the indirect
/// method differ by, and the error of the latter.
///
/// \param extremal  usable()
[[nodiscard]] MeshAnswer answer_from_extremal(const PosedProblem& posed,
                                              const ExtremalSolution& extremal);

}  // namespace brachisto
