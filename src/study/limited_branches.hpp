// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paths under limits that compete for being the answer.

#pragma once

#include <vector>

#include "search/limited_search.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// Refines and certifies every path as an answer of its own and lists them,
/// fastest first, those that turn out to be the same once. The fastest that is
/// verified and feasible, or else verified, becomes the answer.
///
/// \param paths  of posed.limited, on coarse meshes
/// \param out    the principal answer, if there is one
void judge_limited_paths(const PosedProblem& posed,
                         const std::vector<LimitedCurve>& paths, Solution& out);

}  // namespace brachisto
