// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ranges contain what their formulas come to.

#include "math/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brachisto::math {
namespace {

TEST(Interval, ContainsWhatItsFormulasComeTo) {
  constexpr int kRanges = 2000, kPlaces = 20;
  constexpr double kRounding = 1e-12;
  std::mt19937 random(11);
  const auto in = [&](double from, double to) {
    return std::uniform_real_distribution<>(from, to)(random);
  };
  const auto some = [&] {
    const double from = in(-8.0, 8.0);
    return Interval(from, from + std::pow(10.0, in(-3.0, 0.9)));
  };
  const auto formula = [](const auto& a, const auto& b) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const auto s = sin(a);
    return (s * b - cos(b)) / (sqrt(s * s + 70.0) + a) - a;
  };
  for (int i = 0; i < kRanges; ++i) {
    const Interval a = some(), b = some();
    // The denominator has to keep its sign.
    if (a.lower < 0.5) continue;
    const Interval all = formula(a, b);
    for (int k = 0; k < kPlaces; ++k) {
      const double value = formula(in(a.lower, a.upper), in(b.lower, b.upper));
      EXPECT_GE(value, all.lower - kRounding);
      EXPECT_LE(value, all.upper + kRounding);
    }
  }
}

/// Extremes within, at the ends, and over whole turns.
TEST(Interval, KnowsWhereASineTurns) {
  for (int turn = -3; turn <= 3; ++turn) {
    const double top = 0.25 * kTurn + turn * kTurn;
    EXPECT_EQ(sin(Interval(top - 0.1, top + 0.2)).upper, 1.0);
    EXPECT_EQ(sin(Interval(top - 0.1, top + 0.2)).lower, std::sin(top + 0.2));
    EXPECT_LT(sin(Interval(top + 0.1, top + 0.2)).upper, 1.0);
    const Interval all = sin(Interval(top, top + kTurn));
    EXPECT_EQ(all.lower, -1.0);
    EXPECT_EQ(all.upper, 1.0);
  }
}

}  // namespace
}  // namespace brachisto::math
