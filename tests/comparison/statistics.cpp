// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Medians and observed orders of numbers that are known.

#include "comparison/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace brachisto::comparison {
namespace {

/// Some roundings of logarithms, which are at most some tens.
constexpr double kRounding = 1e-13;

TEST(Percentile, IsTheMedianInTheMiddle) {
  EXPECT_EQ(percentile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_EQ(percentile({7.0}, 0.5), 7.0);
}

TEST(Percentile, IsLinearBetweenValues) {
  EXPECT_EQ(percentile({0.0, 10.0, 20.0, 30.0, 40.0}, 0.25), 10.0);
  EXPECT_EQ(percentile({0.0, 10.0}, 0.25), 2.5);
}

TEST(Percentile, EndsWithTheExtremes) {
  const Spread spread = spread_of({5.0, 9.0, 1.0, 4.0});

  EXPECT_EQ(spread.least, 1.0);
  EXPECT_EQ(spread.median, 4.5);
  EXPECT_EQ(spread.greatest, 9.0);
}

/// C n^(−order) on halved meshes.
std::vector<SizeError> power_law(double order, int points) {
  constexpr double kFirst = 10.0, kConstant = 3.7;
  std::vector<SizeError> out;
  for (int i = 0; i < points; ++i) {
    const double n = kFirst * std::exp2(i);
    out.push_back({n, kConstant * std::pow(n, -order)});
  }
  return out;
}

TEST(ObservedOrder, IsThatOfAPowerLaw) {
  for (const double order : {0.5, 1.0, 2.0, 4.0, 12.0}) {
    const auto fit = observed_order(power_law(order, 5), 0.0);

    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->order, order, kRounding * order);
    EXPECT_EQ(fit->points, 5);
    ASSERT_TRUE(fit->uncertainty);
    EXPECT_LT(*fit->uncertainty, kRounding * order);
    EXPECT_NEAR(fit->finest, order, kRounding * order);
  }
}

TEST(ObservedOrder, LeavesOutWhatIsBelowTheFloor) {
  std::vector<SizeError> points = power_law(4.0, 4);
  // Meshes on which rounding is all that is left.
  points.push_back({160.0, 2e-16});
  points.push_back({320.0, 0.0});
  // And one with so many unknowns that rounding is above the floor again.
  points.push_back({10'000.0, 3e-14});

  const auto fit = observed_order(points, 1e-14);

  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 4.0, 4.0 * kRounding);
  EXPECT_EQ(fit->points, 4);
}

TEST(ObservedOrder, OfTwoPointsHasNoUncertainty) {
  const auto fit = observed_order(power_law(2.0, 2), 0.0);

  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 2.0, 2.0 * kRounding);
  EXPECT_FALSE(fit->uncertainty);
}

TEST(ObservedOrder, TellsHowWellItFits) {
  // log₂ of the errors: 0, −1, −3, over log₂ n: 0, 1, 2. By hand: slope −3/2,
  // what is left 1/6, −1/3, 1/6, its squares 1/6, over one degree of freedom
  // and Σ(x − x̄)² = 2: √(1/12).
  const std::vector<SizeError> points{{1.0, 1.0}, {2.0, 0.5}, {4.0, 0.125}};

  const auto fit = observed_order(points, 0.0);

  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 1.5, kRounding);
  EXPECT_NEAR(fit->finest, 2.0, kRounding);
  EXPECT_NEAR(fit->uncertainty.value(), std::sqrt(1.0 / 12.0), kRounding);
}

TEST(ObservedOrder, NeedsTwoMeshesWithAnError) {
  EXPECT_FALSE(observed_order({}, 0.0));
  EXPECT_FALSE(observed_order(power_law(2.0, 1), 0.0));
  EXPECT_FALSE(observed_order(power_law(2.0, 4), 1.0));
  const std::vector<SizeError> same{{10.0, 1e-3}, {10.0, 2e-3}};
  EXPECT_FALSE(observed_order(same, 0.0));
  const std::vector<SizeError> unknown{
      {10.0, 1e-3}, {20.0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_FALSE(observed_order(unknown, 0.0));
}

TEST(AsymptoticOrder, IsThatOfThePowerAboveTheFloor) {
  std::vector<SizeError> points = power_law(4.0, 5);
  // Rounding, which grows with n, within the floor and above it.
  points.push_back({320.0, 4e-15});
  points.push_back({640.0, 9e-15});
  points.push_back({10'000.0, 3e-13});

  const AsymptoticOrder fit = asymptotic_order(points, 1e-14);

  ASSERT_TRUE(fit) << fit.why_not;
  EXPECT_NEAR(fit.order->order, 4.0, 4.0 * kRounding);
  EXPECT_EQ(fit.order->points, 5);
  EXPECT_EQ(fit.order->first, 10.0);
  EXPECT_EQ(fit.order->last, 160.0);
}

TEST(AsymptoticOrder, LeavesOutCoarseMeshesThatDoNotFollowIt) {
  // Coarse meshes that miss what finer ones see: an error that does not fall.
  std::vector<SizeError> points{{2.0, 3e-3}, {3.0, 4e-3}, {5.0, 2.5e-3}};
  for (const SizeError& point : power_law(2.0, 5)) {
    points.push_back({point.n, point.error / 10.0});
  }

  const AsymptoticOrder fit = asymptotic_order(points, 1e-14);

  ASSERT_TRUE(fit) << fit.why_not;
  EXPECT_NEAR(fit.order->order, 2.0, 2.0 * kRounding);
  EXPECT_EQ(fit.order->points, 5);
}

TEST(AsymptoticOrder, IsNotToldOfFewMeshes) {
  const AsymptoticOrder fit = asymptotic_order(power_law(2.0, 3), 0.0);

  EXPECT_FALSE(fit);
  EXPECT_NE(fit.why_not.find("3 of 3 meshes"), std::string::npos)
      << fit.why_not;
}

TEST(AsymptoticOrder, IsNotToldOfAnErrorThatStays) {
  const std::vector<SizeError> stays{
      {10.0, 1.00e-3}, {20.0, 1.02e-3}, {40.0, 0.99e-3}, {80.0, 1.0e-3}};

  EXPECT_FALSE(asymptotic_order(stays, 1e-14));
}

TEST(AsymptoticOrder, IsNotToldWhereTheOrderStillChanges) {
  // 2, 4, 6 from halving to halving.
  const std::vector<SizeError> changes{{10.0, 1.0},
                                       {20.0, std::exp2(-2.0)},
                                       {40.0, std::exp2(-6.0)},
                                       {80.0, std::exp2(-12.0)}};

  const AsymptoticOrder fit = asymptotic_order(changes, 1e-14);

  EXPECT_FALSE(fit);
  EXPECT_NE(fit.why_not.find("2.0, 4.0, 6.0"), std::string::npos)
      << fit.why_not;
}

}  // namespace
}  // namespace brachisto::comparison
