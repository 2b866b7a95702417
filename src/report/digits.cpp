// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brachisto::report {

namespace {

// Beyond them a double has none.
constexpr int kDigits = 15;

bool is_known(double value, double error) {
  return std::isfinite(value) && std::isfinite(error) && error > 0.0;
}

/// Power of ten of the first digit.
int exponent_of(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

/// Decimal places of the error's first digit, no more than the value has.
int decimals(double value, double error) {
  const int most = value == 0.0 ? kDigits : kDigits - 1 - exponent_of(value);
  return std::min(-exponent_of(error), most);
}

}  // namespace

std::string with_error(double value, double error) {
  if (!is_known(value, error)) return fmt::format("{:.12g}", value);
  int places = decimals(value, error);
  double units = std::ceil(error * std::pow(10.0, places));
  if (units >= 10.0) {  // 9.3 units are ten, one of the place before
    --places;
    units = 1.0;
  }
  // An error of one and more has no place behind the point.
  if (places < 0) return fmt::format("{:.0f} ± {:.0e}", value, error);
  return fmt::format("{:.{}f}({:.0f})", value, places, units);
}

std::string within_error(double value, double error) {
  if (!is_known(value, error)) return fmt::format("{:.12g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, decimals(value, error)));
}

}  // namespace brachisto::report
