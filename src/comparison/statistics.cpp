// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brachisto::comparison {

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above],
                   place - static_cast<double>(below));
}

Spread spread_of(const std::vector<double>& values) {
  constexpr double kMedian = 0.5;
  return {percentile(values, 0.0), percentile(values, kMedian),
          percentile(values, 1.0)};
}

std::optional<ObservedOrder> observed_order(std::span<const SizeError> points,
                                            double floor) {
  std::vector<std::pair<double, double>> logs;
  for (const SizeError& point : points) {
    if (point.error <= floor) break;
    if (std::isfinite(point.error)) {
      logs.emplace_back(std::log(point.n), std::log(point.error));
    }
  }
  if (logs.size() < 2) return std::nullopt;
  const auto count = static_cast<double>(logs.size());
  double mean_n = 0.0, mean_error = 0.0;
  for (const auto& [n, error] : logs) {
    mean_n += n / count;
    mean_error += error / count;
  }
  double nn = 0.0, ne = 0.0;
  for (const auto& [n, error] : logs) {
    nn += (n - mean_n) * (n - mean_n);
    ne += (n - mean_n) * (error - mean_error);
  }
  if (!(nn > 0.0)) return std::nullopt;
  const auto& [n0, error0] = logs[logs.size() - 2];
  const auto& [n1, error1] = logs.back();
  ObservedOrder fit{-ne / nn, static_cast<int>(logs.size()), std::nullopt,
                    -(error1 - error0) / (n1 - n0)};
  if (logs.size() > 2) {
    double squares = 0.0;
    for (const auto& [n, error] : logs) {
      const double left = error - mean_error + fit.order * (n - mean_n);
      squares += left * left;
    }
    fit.uncertainty = std::sqrt(squares / (count - 2.0) / nn);
  }
  return fit;
}

}  // namespace brachisto::comparison
