// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sweeps: values of ranges, names and random samples.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

#include "io/sweep_reading.hpp"
#include "support/numbers.hpp"

namespace brachisto::io {
namespace {

using ::testing::ElementsAre;
using testing::kPi;

TEST(SweepRange, HasBothEndsExactly) {
  const std::string ends = "{from: 0.1, to: 1/3, count: 97";

  for (const std::string rest :
       {"}", ", spacing: linear}", ", spacing: log}"}) {
    const std::vector<double> k =
        numbers(sweep({"scene.body.k: " + ends + rest}));
    ASSERT_EQ(k.size(), 97u);
    EXPECT_EQ(k.front(), 0.1);
    EXPECT_EQ(k.back(), 1.0 / 3.0);
    EXPECT_TRUE(std::ranges::is_sorted(k));
  }
}

TEST(SweepRange, LinearHasTheDecimalsOneWouldWrite) {
  EXPECT_THAT(numbers(sweep({"scene.finish.L: {from: 1, to: 2, count: 11}"})),
              ElementsAre(1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9, 2));
}

TEST(SweepRange, LogHasTheDecadesOneWouldWrite) {
  EXPECT_THAT(numbers(sweep({"scene.finish.L: {from: 1e-3, to: 1e3, count: 7, "
                             "spacing: log}"})),
              ElementsAre(1e-3, 1e-2, 1e-1, 1, 10, 100, 1e3));
}

TEST(SweepRange, IsSymmetric) {
  const auto theta = numbers(
      sweep({"scene.body.theta_m: {from: -77 deg, to: 77 deg, count: 58}"}));
  const auto up =
      numbers(sweep({"scene.finish.L: {from: 0.3, to: 7, count: 30, "
                     "spacing: log}"}));
  const auto down =
      numbers(sweep({"scene.finish.L: {from: 7, to: 0.3, count: 30, "
                     "spacing: log}"}));

  for (std::size_t i = 0; i < theta.size(); ++i) {
    EXPECT_EQ(theta[i], -theta[theta.size() - 1 - i]);
  }
  for (std::size_t i = 0; i < up.size(); ++i) {
    EXPECT_EQ(up[i], down[down.size() - 1 - i]);
  }
}

TEST(SweepRange, LogOfNegativeEndsStaysNegative) {
  EXPECT_THAT(numbers(sweep({"scene.body.theta_m: {from: -4, to: -1, count: 3, "
                             "spacing: log}"})),
              ElementsAre(-4, -2, -1));
}

TEST(SweepRange, OfOneValueIsWhereItBegins) {
  EXPECT_THAT(numbers(sweep({"scene.body.k: {from: 0.2, count: 1}"})),
              ElementsAre(0.2));
}

TEST(SweepRange, OfIntegersHasIntegers) {
  EXPECT_THAT(numbers(sweep({"solver.seed: {from: 1, to: 9, count: 1e1-1}"})),
              ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9));
}

TEST(SweepNames, MeanTheValueInTheFile) {
  const SweepFile file =
      sweep({"scene.body.mass: [r, k, L, H, eta_m + 1, theta_m + 2]"});

  EXPECT_THAT(numbers(file), ElementsAre(1.0 / 3.0, 0.5, 3, 1, 1, 2));
}

TEST(SweepNames, MeanTheValueInTheSweepIfTheKeyVaries) {
  const SweepFile file =
      sweep({"scene.finish.H: {from: L/2, to: L, count: 2}",
             "scene.finish.L: [2, 4]", "scene.body.radius: H/10"});

  EXPECT_THAT(numbers(file, 0), ElementsAre(1, 2, 2, 4));
  EXPECT_THAT(numbers(file, 2), ElementsAre(0.1, 0.2, 0.2, 0.4));
}

TEST(SweepNames, StandForAnglesInRadians) {
  const SweepFile file =
      sweep({"scene.body.theta_m: [30 deg]", "scene.body.mass: theta_m",
             "scene.gravity: cos(theta_m)"});

  EXPECT_EQ(number(file, 0, 1), kPi / 6);
  EXPECT_EQ(number(file, 0, 2), std::cos(kPi / 6));
}

TEST(SweepNames, MayStandInAngles) {
  const SweepFile file =
      sweep({"scene.body.theta_m: [eta_m, eta_m*90 deg, (1+k) deg]",
             "scene.body.eta_m: 0.5"});

  EXPECT_THAT(numbers(file), ElementsAre(0.5, kPi / 4, 1.5 * kPi / 180));
}

TEST(SweepSample, IsWhatTheGeneratorGives) {
  const SweepFile file =
      sweep({"random: {seed: 7, count: 100, ranges: {scene.body.eta_m: {from: "
             "0, to: 0.5}, scene.body.theta_m: {from: 0, to: 1}}}"});

  EXPECT_EQ(file.num_scenes(), 100u);
  ASSERT_EQ(file.axes().size(), 1u);
  EXPECT_FALSE(file.axes()[0].ordered);
  EXPECT_THAT(file.axes()[0].keys, ElementsAre(0u, 1u));
  EXPECT_EQ(number(file, 0, 0), 0.35817387690342406 / 2);
  EXPECT_EQ(number(file, 1, 0), 0.13664519380520224 / 2);
  EXPECT_EQ(number(file, 99, 0), 0.4970032791103264 / 2);
  EXPECT_EQ(number(file, 0, 1), 0.8595693092017233);
}

TEST(SweepSample, DoesNotDependOnHowManyThereAreNorOnOtherKeys) {
  const std::string eta_m = "scene.body.eta_m: {from: 0, to: 0.5}";
  const SweepFile few =
      sweep({"random: {seed: 3, count: 5, ranges: {" + eta_m + "}}"});
  const SweepFile many =
      sweep({"random: {seed: 3, count: 50, ranges: {scene.finish.L: {from: 2, "
             "to: 3}, " +
             eta_m + "}}"});
  const SweepFile other =
      sweep({"random: {seed: 4, count: 5, ranges: {" + eta_m + "}}"});

  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(number(few, i, 0), number(many, i, 1));
    EXPECT_NE(number(few, i, 0), number(other, i, 0));
  }
}

TEST(SweepSample, StaysBetweenItsEnds) {
  const SweepFile file =
      sweep({"random: {count: 1000, ranges: {scene.body.k: {from: 0.01, to: "
             "1, spacing: log}, scene.body.eta_m: {from: 0, to: sqrt(1-k)}}}"});

  int below_a_tenth = 0;
  for (std::size_t i = 0; i < file.num_scenes(); ++i) {
    const double k = number(file, i, 0);
    EXPECT_TRUE(0.01 <= k && k <= 1.0);
    EXPECT_TRUE(0.0 <= number(file, i, 1) &&
                number(file, i, 1) <= std::sqrt(1 - k));
    below_a_tenth += k < 0.1 ? 1 : 0;
  }
  // Equal ratios are equally likely: a half of them, within 5 standard
  // deviations of √(1000/4).
  EXPECT_NEAR(below_a_tenth, 500, 5 * std::sqrt(250.0));
}

TEST(SweepSample, IsOneKeyOfTheProduct) {
  const SweepFile file =
      sweep({"random: {seed: 1, count: 3, ranges: {scene.body.k: {from: 0, to: "
             "1}, scene.finish.L: {from: 2, to: 3}}}",
             "scene.finish.H: [1, 2]"});

  EXPECT_EQ(file.num_scenes(), 6u);
  EXPECT_EQ(number(file, 0, 0), number(file, 1, 0));
  EXPECT_EQ(number(file, 0, 1), number(file, 1, 1));
  EXPECT_NE(number(file, 1, 0), number(file, 2, 0));
  EXPECT_EQ(number(file, 1, 2), 2.0);
}

TEST(SweepSample, HasSeedOneUnlessItIsGiven) {
  const std::string rest =
      "count: 2, ranges: {scene.body.k: {from: 0, to: 1}}}";

  EXPECT_EQ(numbers(sweep({"random: {" + rest})),
            numbers(sweep({"random: {seed: 1, " + rest})));
}

TEST(SweepValues, AreTheSameInAllThreads) {
  const SweepFile file =
      sweep({"scene.body.eta_m: {from: 0, to: 0.9, count: 2000}",
             "scene.body.k: 1 - eta_m^2", "scene.body.radius: 1/(1+eta_m)"});
  const std::vector<double> alone = numbers(file, 2);
  std::vector<std::vector<double>> found(4);

  std::vector<std::thread> threads;
  for (std::vector<double>& values : found) {
    threads.emplace_back([&] { values = numbers(file, 2); });
  }
  for (std::thread& thread : threads) thread.join();

  for (const std::vector<double>& values : found) EXPECT_EQ(values, alone);
}

}  // namespace
}  // namespace brachisto::io
