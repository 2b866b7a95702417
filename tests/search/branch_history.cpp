// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "search/branch_history.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brachisto {
namespace {

/// (1 + t)^n, with its coefficients the harder to guess the higher n.
double power(double t, int n) {
  return std::pow(1.0 + t, n);
}

BranchPoint point_at(double fraction, double t, int degree) {
  return {fraction,
          {1, {0.0, 0.1 * power(t, degree), 1.0}},
          {{power(t, degree), -power(t, degree)}, {2.0 * power(t, degree)}},
          3.0 * power(t, degree)};
}

/// Both coordinates of a point have the same error.
double error(const BranchPoint& a, const BranchPoint& b) {
  return std::abs(a.point.x[0] - b.point.x[0]);
}

constexpr double kWanted = 1e-2;
constexpr double kGrowth = 4.0;

void expect_exact(const BranchHistory& history, double fraction, double t,
                  int degree) {
  const double rounding =
      1e3 * std::numeric_limits<double>::epsilon() * std::abs(power(t, degree));
  const BranchPoint predicted = history.predict(fraction);
  const BranchPoint exact = point_at(fraction, t, degree);
  EXPECT_EQ(predicted.fraction, fraction);
  EXPECT_NEAR(predicted.phi, exact.phi, 3.0 * rounding);
  EXPECT_NEAR(predicted.point.x[0], exact.point.x[0], rounding);
  EXPECT_NEAR(predicted.point.x[1], exact.point.x[1], rounding);
  EXPECT_NEAR(predicted.point.lambda[0], exact.point.lambda[0], 2.0 * rounding);
}

TEST(BranchHistory, PredictsPolynomialsInTheFractionExactly) {
  constexpr int kDegree = 3;
  BranchHistory history(point_at(0.0, 0.0, kDegree), {.most_degree = kDegree});
  for (const double fraction : {0.1, 0.15, 0.3, 0.5}) {
    history.add(point_at(fraction, fraction, kDegree), error, kWanted, kGrowth);
  }

  expect_exact(history, 0.7, 0.7, kDegree);
  EXPECT_EQ(history.predict(0.7).mesh.boundaries,
            history.last().mesh.boundaries)
      << "a mesh that does not move";
}

TEST(BranchHistory, PredictsPolynomialsInTheLogarithmBeyondAKnee) {
  constexpr int kDegree = 2;
  constexpr double kKnee = 1e-3;
  const auto t = [](double fraction) { return std::log1p(fraction / kKnee); };
  BranchHistory history(
      point_at(0.0, 0.0, kDegree),
      {.most_degree = kDegree, .knee = kKnee, .moving_mesh = true});
  for (const double fraction : {0.002, 0.004, 0.02}) {
    history.add(point_at(fraction, t(fraction), kDegree), error, kWanted,
                kGrowth);
  }

  expect_exact(history, 0.1, t(0.1), kDegree);
  EXPECT_NEAR(history.predict(0.1).mesh.boundaries[1],
              0.1 * power(t(0.1), kDegree), 1e-12);
  EXPECT_NEAR(history.fraction_at(history.distance(0.3)), 0.3, 1e-15);
}

TEST(BranchHistory, RepeatsTheOnlyPointItHas) {
  const BranchHistory history(point_at(0.0, 0.5, 1), {.most_degree = 4});

  EXPECT_EQ(history.predict(0.2).point.x, history.last().point.x);
}

// The error of interpolation is C (t − t_0) ⋯ (t − t_k) with a constant C if
// the branch is a polynomial of degree k + 1. Steps are tried in ratios of
// 0.95.
TEST(BranchHistory, PromisesStepsWithTheWantedError) {
  constexpr int kDegree = 3;
  BranchHistory history(point_at(0.0, 0.0, kDegree + 1),
                        {.most_degree = kDegree});
  double t = 0.0;
  double step = 0.02;
  for (const double ratio : {1.0, 1.5, 0.8, 1.2, 1.0}) {
    t += ratio * step;
    step = history.add(point_at(t, t, kDegree + 1), error, kWanted, 100.0);
  }
  t += step;

  const double missed = error(history.predict(t), point_at(t, t, kDegree + 1));

  EXPECT_LE(missed, 1.001 * kWanted);
  EXPECT_GE(missed, std::pow(0.95, kDegree + 1) * kWanted);
}

TEST(BranchHistory, ChoosesALineWhereTheBranchHasAKink) {
  const auto bent = [](double t) {
    const double value = t < 0.4 ? 0.0 : t - 0.4;
    return BranchPoint{t, {1, {0.0, 1.0}}, {{value}, {value}}, value};
  };
  BranchHistory history(bent(0.0), {.most_degree = 4});
  for (const double t : {0.1, 0.22, 0.31, 0.5, 0.6, 0.7}) {
    history.add(bent(t), error, kWanted, kGrowth);
  }

  EXPECT_NEAR(history.predict(0.8).phi, bent(0.8).phi, 1e-12);
}

TEST(BranchHistory, PredictsAlongALineAfterAFailure) {
  constexpr int kDegree = 3;
  BranchHistory history(point_at(0.0, 0.0, kDegree), {.most_degree = kDegree});
  for (const double t : {0.1, 0.2, 0.3, 0.4}) {
    history.add(point_at(t, t, kDegree), error, kWanted, kGrowth);
  }
  history.expect_less();

  const double line = 2.0 * power(0.4, kDegree) - power(0.3, kDegree);
  EXPECT_NEAR(history.predict(0.5).point.x[0], line, 1e-14);
}

}  // namespace
}  // namespace brachisto
