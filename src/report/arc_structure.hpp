// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The arcs of a path under limits, one after the other.

#pragma once

#include <string>
#include <vector>

#include "brachisto/study/solution.hpp"

namespace brachisto::report {

/// A stretch along which the same limits hold, or a place at which one is
/// touched.
struct PathArc : ActiveArc {
  std::vector<std::string> holds;  ///< names of the limits; none: it is free
};

/// Names of the limits that hold as equations at σ.
[[nodiscard]] std::vector<std::string> holding_at(
    double sigma, const std::vector<LimitOnPath>& limits);

/// From A to B, with the free arcs between those of Solution::limits; empty
/// without a motion.
[[nodiscard]] std::vector<PathArc> arc_structure(const Solution& solution);

}  // namespace brachisto::report
