// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lines of equal value.

#pragma once

#include <vector>

#include "report/lattice.hpp"

namespace brachisto::report {

/// Lines on which the value, linear along the edges of the grid, equals
/// `level`, by marching squares: only through quadrilaterals whose four corners
/// have values; a saddle is decided by the mean of its corners. Closed lines
/// end where they begin. O(nx · ny).
[[nodiscard]] std::vector<std::vector<Pixel>> contour_lines(
    const Lattice& lattice, double level);

}  // namespace brachisto::report
