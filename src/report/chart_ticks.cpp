// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/chart_ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brachisto::report {

namespace {

/// So much of a decade a tick may be out and still count as within the axis.
constexpr double kSlack = 1e-9;

/// Every power of ten, or every second and so on if they are many, with short
/// ticks at their multiples or at the powers that have no number.
std::vector<Tick> powers_of_ten(double low, double high, int count) {
  const double from = std::log10(low) - kSlack;
  const double to = std::log10(high) + kSlack;
  const int step =
      std::max(1, static_cast<int>(std::ceil((to - from) / count)));
  std::vector<Tick> ticks;
  for (int i = static_cast<int>(std::floor(from)); i <= to; ++i) {
    for (int factor = 1; factor < 10; ++factor) {
      const double value = factor * std::pow(10.0, i);
      const double place = std::log10(value);
      if (place < from || place > to) continue;
      if (factor == 1 && i % step == 0) {
        ticks.push_back({value, i < 0 ? fmt::format("10^{{−{}}}", -i)
                                      : fmt::format("10^{{{}}}", i)});
      } else if (factor == 1 || step == 1) {
        ticks.push_back({value, ""});
      }
    }
  }
  return ticks;
}

std::ptrdiff_t numbers_of(const std::vector<Tick>& ticks) {
  return std::count_if(ticks.begin(), ticks.end(),
                       [](const Tick& tick) { return !tick.words.empty(); });
}

}  // namespace

std::string number_words(double value, int digits) {
  std::string text = printed(value, digits);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::string power = "10^{" + text.substr(e + 1) + "}";
  const std::string factor = text.substr(0, e);
  if (factor == "1") return power;
  return factor == "−1" ? "−" + power : factor + "·" + power;
}

std::vector<Tick> chart_ticks(Scale scale, double low, double high, int count) {
  if (scale == Scale::Logarithmic) {
    std::vector<Tick> ticks = powers_of_ten(low, high, count);
    if (numbers_of(ticks) > 1) return ticks;
  }
  const Axis axis(scale, Axis::laid_out(scale, low),
                  Axis::laid_out(scale, high), 0.0, 1.0);
  std::vector<double> values = axis.ticks(count);
  // On a short piece of a logarithmic scale all round numbers count.
  if (values.size() < 2) values = round_values(low, high, count);
  // As many digits as tell two neighbours apart.
  int digits = 6;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double ratio =
        std::max(std::abs(values[i - 1]), std::abs(values[i])) /
        std::abs(values[i] - values[i - 1]);
    digits = std::max(digits, 2 + static_cast<int>(std::log10(ratio)));
  }
  std::vector<Tick> ticks;
  for (const double value : values) {
    ticks.push_back({value, number_words(value, std::min(digits, 15))});
  }
  return ticks;
}

}  // namespace brachisto::report
