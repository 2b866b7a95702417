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
  BranchHistory history(point_at(0.0, 0.0, kDegree), {.degree = kDegree});
  for (const double fraction : {0.1, 0.15, 0.3, 0.5}) {
    history.add(point_at(fraction, fraction, kDegree));
  }

  EXPECT_EQ(history.degree(), kDegree);
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
      {.degree = kDegree, .knee = kKnee, .moving_mesh = true});
  for (const double fraction : {0.002, 0.004, 0.02}) {
    history.add(point_at(fraction, t(fraction), kDegree));
  }

  expect_exact(history, 0.1, t(0.1), kDegree);
  EXPECT_NEAR(history.predict(0.1).mesh.boundaries[1],
              0.1 * power(t(0.1), kDegree), 1e-12);
  EXPECT_NEAR(history.fraction_at(history.distance(0.3)), 0.3, 1e-15);
}

TEST(BranchHistory, RepeatsTheOnlyPointItHas) {
  const BranchHistory history(point_at(0.0, 0.5, 1), {.degree = 4});

  EXPECT_EQ(history.degree(), 0);
  EXPECT_EQ(history.predict(0.2).point.x, history.last().point.x);
}

}  // namespace
}  // namespace brachisto
