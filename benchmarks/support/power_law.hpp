// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// y ≈ c n^q.

#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "report/chart.hpp"

namespace brachisto::benchmarks {

struct PowerLaw {
  double factor = 0.0, exponent = 0.0;

  [[nodiscard]] double at(double n) const {
    return factor * std::pow(n, exponent);
  }
  /// The n at which it is y.
  [[nodiscard]] double inverse(double y) const {
    return std::pow(y / factor, 1.0 / exponent);
  }
};

/// By least squares of logarithms; nothing from fewer than two points.
/// \param points  (n, y), all > 0
[[nodiscard]] inline std::optional<PowerLaw> fit_power(
    std::span<const report::Datum> points) {
  if (points.size() < 2) return std::nullopt;
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const report::Datum& point : points) {
    const double a = std::log(point.x), b = std::log(point.y);
    count += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  const double exponent = (count * xy - x * y) / (count * xx - x * x);
  return PowerLaw{std::exp((y - exponent * x) / count), exponent};
}

}  // namespace brachisto::benchmarks
