// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "comparison/statistics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/scale.hpp"

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
  report::Extent sizes;
  for (const SizeError& point : points) {
    if (point.error <= floor) break;
    if (std::isfinite(point.error)) {
      sizes.include(point.n);
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
  ObservedOrder fit{-ne / nn,     static_cast<int>(logs.size()),
                    std::nullopt, -(error1 - error0) / (n1 - n0),
                    sizes.low,    sizes.high};
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

namespace {

constexpr std::size_t kLeastMeshes = 4;

/// Whether the errors follow the power that was fitted to them.
bool follow(std::span<const SizeError> points, const ObservedOrder& fit) {
  constexpr double kOff = 1.25, kFall = 2.0, kAgree = 0.1;
  // The fitted line goes through the means of the logarithms.
  double mean = 0.0;
  std::vector<double> constants;  // log(error n^order)
  for (const SizeError& point : points) {
    constants.push_back(std::log(point.error) + fit.order * std::log(point.n));
    mean += constants.back() / static_cast<double>(points.size());
  }
  const bool near = std::ranges::all_of(constants, [&](double constant) {
    return std::abs(constant - mean) <= std::log(kOff);
  });
  const bool falls = fit.order * std::log(points.back().n / points.front().n) >=
                     std::log(kFall);
  if (!near || !falls) return false;
  // They share what is in the middle.
  const std::size_t half = points.size() / 2 + 1;
  const auto coarse = observed_order(points.first(half), 0.0);
  const auto fine = observed_order(points.last(half), 0.0);
  return coarse && fine &&
         std::abs(coarse->order - fine->order) <= kAgree * fit.order;
}

}  // namespace

AsymptoticOrder asymptotic_order(std::span<const SizeError> points,
                                 double floor) {
  const auto end = std::ranges::find_if(
      points, [&](const SizeError& point) { return !(point.error > floor); });
  const std::span<const SizeError> above(points.begin(), end);
  if (above.size() < kLeastMeshes) {
    return {{},
            fmt::format("{} of {} meshes leave an error above {:.0e}; an order "
                        "needs {}",
                        above.size(), points.size(), floor, kLeastMeshes)};
  }
  for (std::size_t count = above.size(); count >= kLeastMeshes; --count) {
    const std::span<const SizeError> run = above.last(count);
    const auto fit = observed_order(run, 0.0);
    if (fit && follow(run, *fit)) return {fit, {}};
  }
  std::vector<std::string> orders;
  for (std::size_t i = above.size() - kLeastMeshes + 1; i < above.size(); ++i) {
    const auto between = observed_order(above.subspan(i - 1, 2), 0.0);
    orders.push_back(between ? fmt::format("{:.1f}", between->order) : "–");
  }
  return {
      {},
      fmt::format("the errors of its finest meshes follow no power: between "
                  "neighbours the order is {}",
                  fmt::join(orders, ", "))};
}

}  // namespace brachisto::comparison
