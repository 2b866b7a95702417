// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What each limit means for the path that was found.

#pragma once

#include <vector>

#include "brachisto/study/solution.hpp"
#include "refinement/arc_fit.hpp"
#include "study/pose.hpp"
#include "trajectory/trajectory.hpp"

namespace brachisto {

/// One for each bound of the scene, in the order of stated_limits().
/// \param motion  of the path
[[nodiscard]] std::vector<LimitOnPath> limits_on_path(
    const PosedProblem& posed, const FittedPath& path,
    const LimitedMotion& motion);

}  // namespace brachisto
