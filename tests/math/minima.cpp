// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/minima.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace brachisto::math {
namespace {

// Values tell a place x to half the bits only, x 2⁻²⁶, and a minimum with f″ =
// 1 to half the square of that.
constexpr double kPlace = 3e-8;

std::vector<Sample> sample(double from, double to, int count,
                           const std::function<double(double)>& f) {
  std::vector<Sample> samples;
  for (int i = 0; i <= count; ++i) {
    const double at = from + (to - from) * i / count;
    samples.push_back({at, f(at)});
  }
  return samples;
}

TEST(FindMinimum, FindsTheVertexOfAParabola) {
  const Sample found = find_minimum(
      [](double x) { return 3.0 + (x - 0.3) * (x - 0.3); }, 0.0, 1.0);

  EXPECT_NEAR(found.at, 0.3, kPlace);
  EXPECT_NEAR(found.value, 3.0, 1e-14);
}

TEST(MinimaBelow, FindsEveryMinimumOfACosine) {
  const auto f = [](double x) { return std::cos(x); };
  // Seven samples per period: a minimum never lies at one of them.
  const std::vector<Sample> samples = sample(0.0, 20.0, 22, f);

  const std::vector<Sample> found = minima_below(0.0, samples, f);

  ASSERT_EQ(found.size(), 3u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double at = (2.0 * static_cast<double>(i) + 1.0) * std::numbers::pi;
    EXPECT_NEAR(found[i].at, at, kPlace * at);
    EXPECT_NEAR(found[i].value, -1.0, 0.5 * kPlace * at * kPlace * at);
  }
}

TEST(MinimaBelow, SeesADipBelowTheBoundThatNoSampleReaches) {
  // (x − ½)² − 1/100 is negative for |x − ½| < 1/10, samples are at 0.39 and
  // 0.61 …
  const auto f = [](double x) { return (x - 0.5) * (x - 0.5) - 0.01; };
  const std::vector<Sample> samples{
      {0.17, f(0.17)}, {0.39, f(0.39)}, {0.61, f(0.61)}, {0.83, f(0.83)}};

  const std::vector<Sample> found = minima_below(0.0, samples, f);

  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at, 0.5, kPlace);
  EXPECT_NEAR(found[0].value, -0.01, 1e-14);
}

TEST(MinimaBelow, LeavesOutWhatStaysAboveTheBound) {
  const auto f = [](double x) { return std::cos(x) + 2.0; };
  int evaluations = 0;
  const auto counted = [&](double x) {
    ++evaluations;
    return f(x);
  };

  EXPECT_TRUE(minima_below(0.0, sample(0.0, 20.0, 22, f), counted).empty());
  EXPECT_EQ(evaluations, 0);
}

TEST(HiddenMinimaBelow, AreThoseThatNoSampleShows) {
  // cos x is below −0.9 for |x − π| < 0.45, and so on: of samples 0.85 apart
  // some lie within, and about 3π none.
  const auto f = [](double x) { return std::cos(x); };
  constexpr double kBound = -0.9;
  const std::vector<Sample> samples{
      {2.3, f(2.3)},   {3.15, f(3.15)}, {4.0, f(4.0)},    {8.0, f(8.0)},
      {8.95, f(8.95)}, {9.9, f(9.9)},   {10.75, f(10.75)}};
  ASSERT_GT(f(8.95), kBound);
  ASSERT_GT(f(9.9), kBound);

  const std::vector<Sample> all = minima_below(kBound, samples, f);
  const std::vector<Sample> found = hidden_minima_below(kBound, samples, f);

  EXPECT_EQ(all.size(), 2u);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at, 3.0 * std::numbers::pi, 10.0 * kPlace);
}

TEST(MinimaBelow, LieNextToTheEndsToo) {
  // Both samples next to the vertex of x² − 2 x lie on one side of it, the end
  // less high, and nearer than a fiftieth of the interval in the last case.
  const auto f = [](double x) { return x * (x - 2.0); };
  for (const auto& [samples, hidden] :
       {std::pair{sample(0.0, 1.3, 2, f), true},
        std::pair{sample(0.9, 2.0, 3, f), true},
        std::pair{sample(0.995, 2.0, 3, f), false}}) {
    const double end = std::min(samples.front().value, samples.back().value);
    for (const double bound : {-0.99999, end}) {
      const std::vector<Sample> found = minima_below(bound, samples, f);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_NEAR(found[0].at, 1.0, kPlace);
      EXPECT_NEAR(found[0].value, -1.0, 1e-14);
    }
    EXPECT_EQ(hidden_minima_below(-0.999, samples, f).size(), hidden ? 1u : 0u);
    EXPECT_TRUE(minima_below(-1.1, samples, f).empty());
  }
  // The end is none, however little f falls towards it.
  EXPECT_TRUE(minima_below(0.0, sample(0.0, 0.99, 2, f), f).empty());
  EXPECT_TRUE(minima_below(0.0, sample(1.01, 2.0, 3, f), f).empty());
}

TEST(MinimaBelow, TheEndsAreNoMinimaAndMayBeInfinite) {
  const auto f = [](double x) { return 1.0 / x + x; };
  std::vector<Sample> samples = sample(0.0, 0.9, 9, f);
  ASSERT_EQ(samples.front().value, std::numeric_limits<double>::infinity());

  EXPECT_TRUE(minima_below(10.0, samples, f).empty());
  samples = sample(0.0, 3.0, 10, f);
  const std::vector<Sample> found = minima_below(10.0, samples, f);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].at, 1.0, kPlace);
}

}  // namespace
}  // namespace brachisto::math
