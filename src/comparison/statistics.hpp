// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Few numbers in place of many.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brachisto::comparison {

/// The value below which a share of the values lies, linear between them: the
/// least for 0, the median for 1/2, the greatest for 1; NaN without values.
/// \pre 0 ≤ share ≤ 1
[[nodiscard]] double percentile(std::vector<double> values, double share);

/// Times of the same work, of which other processes may stretch some.
struct Spread {
  double least = 0.0, median = 0.0, greatest = 0.0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// What a mesh of size n leaves of error.
struct SizeError {
  double n = 0.0;      ///< > 0
  double error = 0.0;  ///< ≥ 0
};

/// error ≈ C n^(−order).
struct ObservedOrder {
  double order = 0.0;
  int points = 0;  ///< that it was fitted to
  /// Standard error of `order`; nothing from two points, which fit exactly.
  std::optional<double> uncertainty;
  /// Between the last two points alone: where it differs much from `order`, the
  /// error does not follow a power yet, or no longer.
  double finest = 0.0;
  double first = 0.0, last = 0.0;  ///< n, of the points
};

/// Fits log(error) over log(n) by least squares to the points before the first
/// whose error is not above `floor`; from there on rounding and tolerances
/// speak, and rounding grows with n. Nothing if fewer than two different n are
/// left.
///
/// \param points  ascending in n
[[nodiscard]] std::optional<ObservedOrder> observed_order(
    std::span<const SizeError> points, double floor);

/// An order, or why there is none.
struct AsymptoticOrder {
  std::optional<ObservedOrder> order;
  std::string why_not;  ///< in words; empty if there is an order

  [[nodiscard]] explicit operator bool() const { return order.has_value(); }
};

/// The order in the asymptotic range: the longest run of meshes that ends with
/// the last one before the floor, four at least, over which the error follows
/// one power of n. It does if no error is off the fitted power by more than a
/// quarter, the orders of the coarser and of the finer half agree to a tenth,
/// and the error falls by half at least.
///
/// \param points  ascending in n
/// \param floor   see observed_order()
[[nodiscard]] AsymptoticOrder asymptotic_order(
    std::span<const SizeError> points, double floor);

}  // namespace brachisto::comparison
