// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The last stages of a solve: what an extremal on a mesh means for track and
/// body, whether it is one, and what is said of it.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "refinement/limited_refinement.hpp"
#include "refinement/refinement.hpp"
#include "study/answer_kinds.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// The motion that was found and its figures.
struct Answered {
  std::shared_ptr<const Answer> answer;
  std::optional<double> estimated_error;       ///< relative, of T
  std::optional<PathDiagnostics> diagnostics;  ///< unless the motion stalls
  std::vector<LimitOnPath> limits = {};        ///< see Solution::limits
};

/// \param transit_time  T [s], if it is known better than from the mesh
[[nodiscard]] Answered answer_of(
    const PosedProblem& posed, const MeshAnswer& found,
    std::optional<double> transit_time = std::nullopt);
[[nodiscard]] Answered answer_of(const PosedProblem& posed,
                                 ArcLengthAnswer& found);
[[nodiscard]] Answered answer_of(
    const PosedProblem& posed, const LimitedAnswer& found,
    std::optional<double> transit_time = std::nullopt);
/// \throws std::invalid_argument  if the path that the scene states cannot be
[[nodiscard]] Answered answer_on_given_path(const PosedProblem& posed);

/// The limits of a scene on a path that reaches none of them: T does not change
/// with their bounds.
[[nodiscard]] std::vector<LimitOnPath> limits_held_nowhere(
    const Motion& motion);

/// What tests say of an answer.
struct Certified {
  Certificate certificate;
  std::optional<CrossCheck> cross_check;  ///< if it was asked for
};

/// \param curve  of `found`
[[nodiscard]] Certified certify(const PosedProblem& posed, MeshAnswer& found,
                                const ExtremalCurve& curve);
[[nodiscard]] Certified certify(const PosedProblem& posed,
                                const LimitedAnswer& found);
/// \param motion  of `found`
/// \param nearby  an extremal of the scene, with the end angle φ
[[nodiscard]] Certified certify(const PosedProblem& posed,
                                ArcLengthAnswer& found,
                                const ArcLengthMotion& motion,
                                const ExtremalCurve& nearby, double phi);

[[nodiscard]] Certified certify_given_path(const PosedProblem& posed,
                                           const PrescribedMotion& motion);

/// What is said of a certified answer, whose status and message are those of
/// its refinement: that a finer mesh failed only matters if this one is not
/// good enough.
/// \param found  the message of the solver that found it
[[nodiscard]] Outcome verdict(const Solution& certified,
                              const std::string& found);

}  // namespace brachisto
