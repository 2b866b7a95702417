// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where limits of a scene do not let the body be, for pictures.

#pragma once

#include <vector>

#include "brachisto/model/path_limits.hpp"

namespace brachisto::report {

/// Corners of a convex area, in order.
using Outline = std::vector<Point>;

/// What lies below the floor, in a disc and behind a half-plane, as far as it
/// lies between two opposite corners of a frame [m]; nothing of what does not.
[[nodiscard]] std::vector<Outline> obstacles(const PathLimits& limits,
                                             Point low, Point high);

}  // namespace brachisto::report
