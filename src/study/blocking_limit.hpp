// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which limit was not kept, in words.

#pragma once

#include <string>

#include "refinement/tightening.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// "; the tightest is friction: …": the limit as the scene states it, by how
/// much the nearest path misses it at the nodes, and what can help.
[[nodiscard]] std::string in_words(const PosedProblem& posed,
                                   const BlockingLimit& blocking);

/// What can help a scene whose limits were kept and that was not solved, of the
/// limit that is the likeliest to be in the way; empty if it has none.
[[nodiscard]] std::string looser_limits(const Scene& asked);

}  // namespace brachisto
