// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Scalars that formulas are asked with besides numbers and jets: four numbers
/// at once, and intervals.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace brachisto::testing {

/// A decision about each of four numbers.
struct Mask {
  std::array<bool, 4> lane{};
};

/// Four numbers at once, as a vector register holds them.
struct Lanes {
  std::array<double, 4> lane{};

  Lanes() = default;
  Lanes(double all) { lane.fill(all); }  // NOLINT: numbers are lanes
  explicit Lanes(const std::array<double, 4>& lanes) : lane(lanes) {}

  template <class Operation>
  [[nodiscard]] static Lanes each(const Lanes& a, const Lanes& b,
                                  Operation of) {
    Lanes out;
    for (std::size_t i = 0; i < 4; ++i) out.lane[i] = of(a.lane[i], b.lane[i]);
    return out;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return each(a, b, [](double x, double y) { return x + y; });
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return each(a, b, [](double x, double y) { return x - y; });
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return each(a, b, [](double x, double y) { return x * y; });
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return each(a, b, [](double x, double y) { return x / y; });
  }
  friend Lanes operator-(const Lanes& a) { return Lanes(0.0) - a; }
  Lanes& operator+=(const Lanes& other) { return *this = *this + other; }
  Lanes& operator-=(const Lanes& other) { return *this = *this - other; }

  friend Mask operator>(const Lanes& a, const Lanes& b) {
    Mask out;
    for (std::size_t i = 0; i < 4; ++i) out.lane[i] = a.lane[i] > b.lane[i];
    return out;
  }
  friend Mask operator<(const Lanes& a, const Lanes& b) { return b > a; }
};

[[nodiscard]] inline Lanes where(const Mask& mask, const Lanes& a,
                                 const Lanes& b) {
  Lanes out;
  for (std::size_t i = 0; i < 4; ++i) {
    out.lane[i] = mask.lane[i] ? a.lane[i] : b.lane[i];
  }
  return out;
}
[[nodiscard]] inline bool all(const Mask& mask) {
  return std::all_of(mask.lane.begin(), mask.lane.end(),
                     [](bool holds) { return holds; });
}
[[nodiscard]] inline double magnitude(const Lanes& a) {
  double out = 0.0;
  for (const double x : a.lane) {
    if (!(std::abs(x) <= out)) out = std::abs(x);
  }
  return out;
}
/// Which side of a surface all of them are on.
[[nodiscard]] inline double plain(const Lanes& a) {
  return a.lane[0];
}
[[nodiscard]] inline Lanes sin(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::sin(x); });
}
[[nodiscard]] inline Lanes cos(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::cos(x); });
}
[[nodiscard]] inline Lanes sqrt(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::sqrt(x); });
}
[[nodiscard]] inline Lanes exp(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::exp(x); });
}
[[nodiscard]] inline Lanes log(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::log(x); });
}
[[nodiscard]] inline Lanes atan(const Lanes& a) {
  return Lanes::each(a, a, [](double x, double) { return std::atan(x); });
}

/// All numbers between two; what rounding does is put outside.
struct Interval {
  double low = 0.0, high = 0.0;

  Interval() = default;
  Interval(double number)
      : low(number), high(number) {}  // NOLINT: so are these
  Interval(double from, double to)
      : low(std::nextafter(from, -kInfinity)),
        high(std::nextafter(to, kInfinity)) {}

  [[nodiscard]] bool contains(double x) const { return low <= x && x <= high; }
  [[nodiscard]] double width() const { return high - low; }

  friend Interval operator+(const Interval& a, const Interval& b) {
    return {a.low + b.low, a.high + b.high};
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return {a.low - b.high, a.high - b.low};
  }
  friend Interval operator-(const Interval& a) { return Interval(0.0) - a; }
  friend Interval operator*(const Interval& a, const Interval& b) {
    const auto [low, high] = std::minmax(
        {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    return {low, high};
  }
  /// Of what does not contain zero.
  friend Interval operator/(const Interval& a, const Interval& b) {
    return a * Interval(1.0 / b.high, 1.0 / b.low);
  }
  Interval& operator+=(const Interval& other) { return *this = *this + other; }
  Interval& operator-=(const Interval& other) { return *this = *this - other; }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
};

[[nodiscard]] inline Interval sin(const Interval& a) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const auto reaches = [&](double extreme) {
    return std::floor((a.high - extreme) / kTurn) >
           std::floor((a.low - extreme) / kTurn);
  };
  const double first = std::sin(a.low), last = std::sin(a.high);
  return {reaches(-0.25 * kTurn) ? -1.0 : std::min(first, last),
          reaches(0.25 * kTurn) ? 1.0 : std::max(first, last)};
}
[[nodiscard]] inline Interval cos(const Interval& a) {
  return sin(a + Interval(0.5 * std::numbers::pi, 0.5 * std::numbers::pi));
}
[[nodiscard]] inline Interval sqrt(const Interval& a) {
  return {std::sqrt(a.low), std::sqrt(a.high)};
}
// These rise with a.
[[nodiscard]] inline Interval exp(const Interval& a) {
  return {std::exp(a.low), std::exp(a.high)};
}
[[nodiscard]] inline Interval log(const Interval& a) {
  return {std::log(a.low), std::log(a.high)};
}
[[nodiscard]] inline Interval atan(const Interval& a) {
  return {std::atan(a.low), std::atan(a.high)};
}
[[nodiscard]] inline double plain(const Interval& a) {
  return 0.5 * (a.low + a.high);
}

}  // namespace brachisto::testing
