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
/// \param rows  places so close that the two forces change order at most once
///              between neighbours, the first one the start, the last one the
///              end; where they do, the place is found as a root
[[nodiscard]] double friction_share(const Motion& motion,
                                    const std::vector<TrajectoryPoint>& rows,
                                    double mu);

}  // namespace brachisto
