// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which limit was not kept, in words.

#pragma once

#include <string>

#include "refinement/limited_refinement.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// What is to be said of a scene without an answer behind the reason: the limit
/// that was not kept as the scene states it, by how much the nearest path
/// misses it at the nodes, what can help, and what was tried.
[[nodiscard]] std::string advice_without_answer(
    const PosedProblem& posed, const LimitedRefinement& refinement);

/// What can help where no limit is known to be in the way of an answer: any of
/// them may be; empty if it has none.
[[nodiscard]] std::string looser_limits(const Scene& asked);

}  // namespace brachisto
