// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The order with which an error falls.

#pragma once

#include <cmath>
#include <span>

namespace brachisto::testing {

/// Slope of log(error) over log(h) by least squares; two points or more, all
/// positive.
[[nodiscard]] inline double observed_order(std::span<const double> h,
                                           std::span<const double> error) {
  double sum_a = 0.0, sum_b = 0.0, sum_aa = 0.0, sum_ab = 0.0;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const double a = std::log(h[i]);
    const double b = std::log(error[i]);
    sum_a += a;
    sum_b += b;
    sum_aa += a * a;
    sum_ab += a * b;
  }
  const auto n = static_cast<double>(h.size());
  return (n * sum_ab - sum_a * sum_b) / (n * sum_aa - sum_a * sum_a);
}

}  // namespace brachisto::testing
