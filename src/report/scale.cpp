// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/scale.hpp"

#include <fmt/format.h>

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

std::string with_minus_signs(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool sign = text[i] == '-' && i + 1 < text.size() &&
                      text[i + 1] >= '0' && text[i + 1] <= '9';
    out += sign ? "−" : text.substr(i, 1);
  }
  return out;
}

Scale suitable_scale(std::vector<double> values) {
  constexpr double kDecade = 10.0;
  if (values.empty()) return Scale::Linear;
  std::ranges::sort(values);
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

namespace {

constexpr std::array<Colour, 9> kViridis{{{68, 1, 84},
                                          {71, 45, 123},
                                          {59, 82, 139},
                                          {44, 114, 142},
                                          {33, 145, 140},
                                          {40, 174, 128},
                                          {94, 201, 98},
                                          {173, 220, 48},
                                          {253, 231, 37}}};

}  // namespace

Colour colour_at(double share) {
  const double place =
      std::clamp(share, 0.0, 1.0) * static_cast<double>(kViridis.size() - 1);
  const auto below =
      std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double t = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t c = 0; c < colour.size(); ++c) {
    colour[c] = std::lerp(kViridis[below][c], kViridis[below + 1][c], t);
  }
  return colour;
}

std::string hex(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(colour[0]),
                     std::lround(colour[1]), std::lround(colour[2]));
}

std::vector<std::string> family_colours(std::size_t n) {
  constexpr double kLightest = 0.75;  // lighter ones would be lost on white
  constexpr double kAlone = 0.4;
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < n; ++i) {
    const double share =
        n == 1 ? kAlone : static_cast<double>(i) / static_cast<double>(n - 1);
    colours.push_back(hex(colour_at(kLightest * share)));
  }
  return colours;
}

std::string palette() {
  std::string out;
  for (std::size_t i = 0; i < kViridis.size(); ++i) {
    out += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, hex(kViridis[i]));
  }
  return out;
}

}  // namespace brachisto::report
