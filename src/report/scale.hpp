// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How numbers are laid out along an axis, in colours, and how they are
/// written.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::report {

/// Degrees are laid out evenly, with ticks at parts of a turn.
enum class Scale { Linear, Logarithmic, Degrees };

/// Logarithmic if the values are positive, span a decade, and have their median
/// nearer to the middle of a logarithmic scale than to that of a linear one.
[[nodiscard]] Scale suitable_scale(std::vector<double> values);

/// A number to read, of at most that many digits, with a real minus sign.
[[nodiscard]] std::string printed(double value, int digits = 6);

/// A text with real minus signs before digits.
[[nodiscard]] std::string with_minus_signs(std::string_view text);

/// Least and greatest of finite numbers, or what a picture shows of them.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double width() const { return high - low; }
};

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

/// n colours for a family of curves, dark to light, the lightest still to be
/// seen on white.
[[nodiscard]] std::vector<std::string> family_colours(std::size_t n);

}  // namespace brachisto::report
