// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How numbers are laid out along an axis, and how they are written.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brachisto::report {

/// Degrees are laid out evenly, with ticks at parts of a turn.
enum class Scale { Linear, Logarithmic, Degrees };

/// Logarithmic if the values are positive, span a decade, and have their median
/// nearer to the middle of a logarithmic scale than to that of a linear one.
[[nodiscard]] Scale suitable_scale(std::vector<double> values);

/// A number to read, of at most that many digits, with a real minus sign.
[[nodiscard]] std::string printed(double value, int digits = 6);

/// Least and greatest of finite numbers.
struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace brachisto::report
