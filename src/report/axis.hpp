// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// From values to pixels, with round numbers on the way.

#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brachisto::report {

/// How values are laid out, and which of them are round. Degrees are laid out
/// evenly, with ticks at parts of a turn.
enum class Scale { Linear, Logarithmic, Degrees };

/// 1, 2 or 5 times a power of ten, so that about `count` steps fill `span`.
[[nodiscard]] double tick_step(double span, int count);

/// The multiples of tick_step() from `low` to `high`.
[[nodiscard]] std::vector<double> round_values(double low, double high,
                                               int count);

/// A number to read, of at most that many digits, with a real minus sign.
[[nodiscard]] std::string printed(double value, int digits = 6);

/// Logarithmic if the values are positive, span a decade, and have their median
/// nearer to the middle of a logarithmic scale than to that of a linear one.
[[nodiscard]] Scale suitable_scale(std::vector<double> values);

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

/// A place of an axis that is marked.
struct Tick {
  double value = 0.0;
  std::string words;  ///< rich text; empty: a short tick without a number
};

/// One side of a plot.
class Axis {
 public:
  /// \param low, high  laid_out() values at the pixels `from` and `to`; if they
  ///                   are equal or not finite, the axis is one unit long
  Axis(Scale scale, double low, double high, double from, double to);

  /// Where the scale puts a value: the value itself or its decadic logarithm.
  [[nodiscard]] static double laid_out(Scale scale, double value);

  /// Pixel of a value.
  [[nodiscard]] double operator()(double value) const {
    return pixel(laid_out(scale_, value));
  }
  /// Pixel of a value that is laid out already.
  [[nodiscard]] double pixel(double laid_out) const {
    return from_ + (laid_out - low_) / (high_ - low_) * (to_ - from_);
  }
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }

  /// About `count` round values.
  [[nodiscard]] std::vector<double> ticks(int count) const;

 private:
  Scale scale_;
  double low_, high_, from_, to_;
};

}  // namespace brachisto::report
