// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Between collocation and the indirect method, whose extremal may be a start,
/// a witness, and with the method Shooting the answer.

#pragma once

#include "extremal/shooting.hpp"
#include "model/units.hpp"
#include "refinement/refinement.hpp"
#include "study/pose.hpp"
#include "transcription/extremal_curve.hpp"

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

/// The principal extremal, through folds, by the indirect method.
/// \param tolerance  relative, of T
[[nodiscard]] ExtremalSolution shoot(
    const Scene& scene, const StopCondition& stop,
    double tolerance = ExtremalOptions{}.tolerance);

/// How the indirect method ended.
/// \pre it had a cycloid to start from; see without_cycloid()
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
