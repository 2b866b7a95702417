// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How far two paths of the centre are apart.

#pragma once

#include <optional>
#include <vector>

#include "brachisto/study/solution.hpp"

namespace brachisto::comparison {

/// Places of the centre at equal parts of its path, both ends included [m]; of
/// the discrete system on the chords between its nodes. Empty without a
/// solution.
[[nodiscard]] std::vector<Point> places_along(const Solution& solution);

/// The largest distance between places that belong together, relative to
/// `length`; nothing unless both paths have the same number of them.
[[nodiscard]] std::optional<double> path_error(
    const std::vector<Point>& places, const std::vector<Point>& reference,
    double length);

}  // namespace brachisto::comparison
