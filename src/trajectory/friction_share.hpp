// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How long a motion needs more friction than there is.

#pragma once

#include <vector>

#include "brachisto/trajectory/motion.hpp"

namespace brachisto {

/// Share of the transit time on which not |R_t| ≤ μ R_n.
///
/// \param samples  so close that |R_t| − μ R_n has at most one extreme between
///                 neighbours, the first one the start, the last one the end;
///                 changes of its sign are found as roots
[[nodiscard]] double friction_share(const Motion& motion,
                                    const std::vector<TrajectoryPoint>& samples,
                                    double mu);

}  // namespace brachisto
