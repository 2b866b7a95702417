// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Colours for numbers.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace brachisto::report {

/// Red, green and blue of sRGB, from 0 to 255.
using Colour = std::array<double, 3>;

/// From dark violet at 0 to light yellow at 1 in steps that look equal, each
/// lighter than the one before, so that it reads in grey: nine colours of
/// viridis (N. Smith and S. van der Walt, CC0) and straight lines between them.
[[nodiscard]] Colour colour_at(double share);

/// "#rrggbb".
[[nodiscard]] std::string hex(const Colour& colour);

/// The same colours for "set palette defined (…)" of gnuplot.
[[nodiscard]] std::string palette();

/// Values that stand for both ends of the colours or of an axis.
struct ValueRange {
  double low, high;
};

/// n colours for a family of curves, dark to light, the lightest still to be
/// seen on white.
[[nodiscard]] std::vector<std::string> family_colours(std::size_t n);

}  // namespace brachisto::report
