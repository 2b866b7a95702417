// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brachisto::report {

std::string printed(double value, int digits) {
  // Adding zero turns −0 into 0.
  std::string text = fmt::format("{:.{}g}", value + 0.0, digits);
  // An exponent without plus sign and zeros in front: 1e6, not 1e+06.
  if (const std::size_t e = text.find('e'); e != std::string::npos) {
    const std::size_t digit = text.find_first_not_of("+-0", e + 1);
    text.replace(e + 1, digit - e - 1, text[e + 1] == '-' ? "-" : "");
  }
  for (std::size_t at = text.find('-'); at != std::string::npos;
       at = text.find('-', at + 1)) {
    text.replace(at, 1, "−");
  }
  return text;
}

Scale suitable_scale(std::vector<double> values) {
  constexpr double kDecade = 10.0;
  if (values.empty()) return Scale::Linear;
  std::sort(values.begin(), values.end());
  const double low = values.front();
  const double high = values.back();
  if (!(low > 0.0) || !(high >= kDecade * low)) return Scale::Linear;
  const double median = values[values.size() / 2];
  const double linear = (median - low) / (high - low);
  const double logarithmic = std::log(median / low) / std::log(high / low);
  return std::abs(logarithmic - 0.5) < std::abs(linear - 0.5)
             ? Scale::Logarithmic
             : Scale::Linear;
}

}  // namespace brachisto::report
