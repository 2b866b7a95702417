// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Where a track meets itself.

#pragma once

#include <optional>
#include <vector>

#include "model/contact.hpp"

namespace brachisto {

/// As a share of the size of a track: how far a fold runs back, or a loop
/// extends, that is no more than meshes tell of slopes.
inline constexpr double kShortestFold = 1e-7;

/// A point where the polyline through `points` crosses itself, the first one
/// in the order of x; nothing if it does not. Segments that share an end do not
/// cross there. O(n log n) for a line that mostly advances in x.
[[nodiscard]] std::optional<Point> self_crossing(
    const std::vector<Point>& points);

}  // namespace brachisto
