// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brachisto::report {

namespace {

/// So much of a step a value may be out and still count as within the axis.
constexpr double kSlack = 1e-9;

std::vector<double> multiples(double step, double low, double high) {
  std::vector<double> values;
  // Adding zero turns −0 into 0.
  for (double i = std::ceil(low / step - kSlack) + 0.0;
       i * step <= high + kSlack * step; ++i) {
    values.push_back(i * step);
  }
  return values;
}

double degree_step(double span, int count) {
  const double raw = span / count;
  for (const double step : {10.0, 15.0, 30.0, 45.0, 60.0, 90.0, 180.0, 360.0}) {
    if (raw > 5.0 && step >= raw) return step;
  }
  return tick_step(span, count);
}

/// Powers of ten; if they are few, also twice and five times each.
std::vector<double> decades(double low, double high, int count) {
  const bool fine = 2.0 * (high - low) <= count;
  const int step =
      std::max(1, static_cast<int>(std::ceil((high - low) / count)));
  std::vector<double> values;
  for (int i = static_cast<int>(std::floor(low)); i <= high; i += step) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double value = factor * std::pow(10.0, i);
      const double place = std::log10(value);
      if (place < low - kSlack || place > high + kSlack) continue;
      if (fine || factor == 1.0) values.push_back(value);
    }
  }
  return values;
}

}  // namespace

double tick_step(double span, int count) {
  const double raw = span / count;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= raw) return factor * power;
  }
  return 10.0 * power;
}

std::vector<double> round_values(double low, double high, int count) {
  return multiples(tick_step(high - low, count), low, high);
}

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

Axis::Axis(Scale scale, double low, double high, double from, double to)
    : scale_(scale), low_(low), high_(high), from_(from), to_(to) {
  if (!std::isfinite(low) || !std::isfinite(high)) low_ = high_ = 0.0;
  const double smallest = 1e-9 * std::max(std::abs(low_), std::abs(high_));
  if (high_ - low_ > smallest) return;
  low_ -= 0.5;
  high_ += 0.5;
}

double Axis::laid_out(Scale scale, double value) {
  return scale == Scale::Logarithmic ? std::log10(value) : value;
}

std::vector<double> Axis::ticks(int count) const {
  switch (scale_) {
    case Scale::Linear:
      break;
    case Scale::Logarithmic:
      return decades(low_, high_, count);
    case Scale::Degrees:
      return multiples(degree_step(high_ - low_, count), low_, high_);
  }
  return round_values(low_, high_, count);
}

}  // namespace brachisto::report
