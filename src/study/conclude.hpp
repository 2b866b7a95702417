// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From what a refinement found to what the solution says: answer, certificate,
/// verdict.

#pragma once

#include <optional>
#include <string>

#include "study/answer.hpp"
#include "study/pose.hpp"
#include "study/start.hpp"

namespace brachisto {

/// \param transit_time  T [s], if it is known better than from the mesh
void conclude(const PosedProblem& posed, MeshAnswer& found, Solution& out,
              std::optional<double> transit_time = std::nullopt);
/// \param start  an extremal of the scene, for a cross-check
void conclude(const PosedProblem& posed, ArcLengthAnswer& found,
              const Start& start, Solution& out);
void conclude(const PosedProblem& posed, const LimitedAnswer& found,
              const std::string& message, Solution& out,
              std::optional<double> transit_time = std::nullopt);
/// With how it was refined; without an answer the limit that was not kept and
/// the answer under looser ones.
void conclude(const PosedProblem& posed, const LimitedRefinement& refinement,
              Solution& out);
/// Where to look for another path if one is not verified.
enum class Elsewhere { WithoutArcs, Nowhere };

/// The same, and again on halved elements where T is accurate and the path not
/// yet, or elsewhere where that does not lead to a verified path.
void conclude_resolved(const PosedProblem& posed, LimitedRefinement found,
                       Solution& out,
                       Elsewhere elsewhere = Elsewhere::WithoutArcs);

/// With the limit that was not kept.
void record_limited(const PosedProblem& posed,
                    const LimitedRefinement& refinement, Solution& out);
/// The answer under looser limits, if it is verified.
void record_loosened(const PosedProblem& posed,
                     const LimitedRefinement& refinement, Solution& out);

}  // namespace brachisto
