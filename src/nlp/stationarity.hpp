// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Multipliers that stationarity determines.

#pragma once

#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

/// Gives some constraints the multipliers with which f + λᵀg is stationary in
/// as many variables, the other multipliers being kept: a square linear system,
/// which is solved densely.
///
/// \param problem  has been moved to the point
void make_stationary(const Problem& problem, const std::vector<int>& variables,
                     const std::vector<int>& constraints, PrimalDual& point);

}  // namespace brachisto::nlp
