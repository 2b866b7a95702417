// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/polynomial_basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numeric>

#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

constexpr int kLargestCount = 20;

/// ∫₀¹ t^degree dt by the rule, summed without rounding.
double moment(const std::vector<double>& points,
              const std::vector<double>& weights, int degree) {
  Wide sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += weights[i] * pow(Wide(points[i]), degree);
  }
  return sum.convert_to<double>();
}

TEST(GaussLegendre, IntegratesPolynomialsOfDegreeTwiceTheCountMinusOne) {
  for (int n = 1; n <= kLargestCount; ++n) {
    const math::QuadratureRule rule = math::gauss_legendre(n);
    for (int degree = 0; degree < 2 * n; ++degree) {
      // Weights are off by an ulp of themselves, and points by one of theirs,
      // which t^d sees d-fold while its integral is 1/(d + 1); the sum of the
      // weights is 1.
      EXPECT_NEAR(moment(rule.points, rule.weights, degree), 1.0 / (degree + 1),
                  ulps(2.0))
          << "n " << n << " degree " << degree;
    }
  }
}

TEST(GaussLegendre, HasTheKnownErrorForTheNextDegree) {
  // For t^{2n} it falls short by (n!)⁴ / ((2n + 1) ((2n)!)²).
  for (int n = 1; n <= 10; ++n) {
    const math::QuadratureRule rule = math::gauss_legendre(n);
    const double ratio =
        std::pow(std::tgamma(n + 1), 2) / std::tgamma(2 * n + 1);
    const double error = ratio * ratio / (2 * n + 1);

    EXPECT_NEAR(1.0 / (2 * n + 1) - moment(rule.points, rule.weights, 2 * n),
                error, ulps(2.0) + ulps(16.0, error))
        << "n " << n;
  }
}

TEST(GaussLegendre, HasThePointsAndWeightsOfTheHandbook) {
  // On [−1, 1]: ±1/√3; 0, ±√(3/5) with 8/9, 5/9; 0, ±⅓√(5 ∓ 2√(10/7)) with
  // 128/225, (322 ± 13√70)/900.
  const auto two = math::gauss_legendre(2);
  const auto three = math::gauss_legendre(3);
  const auto five = math::gauss_legendre(5);

  EXPECT_DOUBLE_EQ(two.points[0], 0.5 - 0.5 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(two.weights[0], 0.5);
  EXPECT_DOUBLE_EQ(three.points[2], 0.5 + 0.5 * std::sqrt(0.6));
  EXPECT_DOUBLE_EQ(three.weights[0], 5.0 / 18.0);
  EXPECT_DOUBLE_EQ(three.weights[1], 8.0 / 18.0);
  const double inner = std::sqrt(5.0 - 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  const double outer = std::sqrt(5.0 + 2.0 * std::sqrt(10.0 / 7.0)) / 3.0;
  EXPECT_DOUBLE_EQ(five.points[2], 0.5);
  EXPECT_DOUBLE_EQ(five.points[3], 0.5 + 0.5 * inner);
  EXPECT_DOUBLE_EQ(five.points[4], 0.5 + 0.5 * outer);
  EXPECT_DOUBLE_EQ(five.weights[2], 64.0 / 225.0);
  EXPECT_DOUBLE_EQ(five.weights[3], (322.0 + 13.0 * std::sqrt(70.0)) / 1800.0);
  EXPECT_DOUBLE_EQ(five.weights[4], (322.0 - 13.0 * std::sqrt(70.0)) / 1800.0);
}

/// The upper half of the points, from Boost's tables on [−1, 1].
template <int Count>
void expect_tabulated() {
  using Table = boost::math::quadrature::gauss<double, Count>;
  const math::QuadratureRule rule = math::gauss_legendre(Count);
  const auto& abscissa = Table::abscissa();
  const auto& weights = Table::weights();
  for (std::size_t i = 0; i < abscissa.size(); ++i) {
    const std::size_t upper = Count / 2 + i;
    // The last bit of either.
    EXPECT_NEAR(rule.points[upper], 0.5 + 0.5 * abscissa[i], ulps(1.0))
        << "n " << Count << " point " << upper;
    EXPECT_NEAR(rule.weights[upper], 0.5 * weights[i], ulps(1.0, weights[i]))
        << "n " << Count << " weight " << upper;
  }
}

TEST(GaussLegendre, AgreesWithTables) {
  expect_tabulated<7>();
  expect_tabulated<10>();
  expect_tabulated<15>();
  expect_tabulated<20>();
}

TEST(GaussLegendre, IsPositiveAscendingAndSymmetric) {
  for (int n = 1; n <= kLargestCount; ++n) {
    const auto [points, weights] = math::gauss_legendre(n);

    ASSERT_EQ(points.size(), static_cast<std::size_t>(n));
    ASSERT_EQ(weights.size(), static_cast<std::size_t>(n));
    EXPECT_TRUE(std::ranges::is_sorted(points)) << "n " << n;
    EXPECT_GT(points.front(), 0.0) << "n " << n;
    EXPECT_LT(points.back(), 1.0) << "n " << n;
    EXPECT_GT(*std::ranges::min_element(weights), 0.0) << "n " << n;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::size_t other = points.size() - 1 - i;
      EXPECT_NEAR(points[i] + points[other], 1.0, ulps(1.0)) << "n " << n;
      EXPECT_NEAR(weights[i], weights[other], ulps(1.0, weights[i]))
          << "n " << n;
    }
  }
}

TEST(GaussLobatto, HasThePointsOfTheHandbook) {
  // On [−1, 1]: ±1; 0; ±1/√5; 0, ±√(3/7); ±√(1/3 ∓ 2√7/21).
  const auto two = math::gauss_lobatto_points(2);
  const auto three = math::gauss_lobatto_points(3);
  const auto four = math::gauss_lobatto_points(4);
  const auto five = math::gauss_lobatto_points(5);
  const auto six = math::gauss_lobatto_points(6);

  EXPECT_EQ(two, (std::vector{0.0, 1.0}));
  EXPECT_EQ(three, (std::vector{0.0, 0.5, 1.0}));
  EXPECT_NEAR(four[1], 0.5 - 0.5 / std::sqrt(5.0), ulps(1.0));
  EXPECT_NEAR(five[3], 0.5 + 0.5 * std::sqrt(3.0 / 7.0), ulps(1.0));
  const double root = 2.0 * std::sqrt(7.0) / 21.0;
  EXPECT_NEAR(six[3], 0.5 + 0.5 * std::sqrt(1.0 / 3.0 - root), ulps(1.0));
  EXPECT_NEAR(six[4], 0.5 + 0.5 * std::sqrt(1.0 / 3.0 + root), ulps(1.0));
}

TEST(GaussLobatto, WithItsWeightsIntegratesDegreeTwiceTheCountMinusThree) {
  // Weights 1/(n (n − 1) P_{n−1}²) on [0, 1].
  for (int n = 2; n <= 13; ++n) {
    const std::vector<double> points = math::gauss_lobatto_points(n);
    std::vector<double> weights;
    for (const double t : points) {
      const double P = boost::math::legendre_p(n - 1, 2.0 * t - 1.0);
      weights.push_back(1.0 / (n * (n - 1) * P * P));
    }

    for (int degree = 0; degree <= 2 * n - 3; ++degree) {
      // P_{n−1} is stationary at the points, so only its own recurrence rounds,
      // n steps of it.
      EXPECT_NEAR(moment(points, weights, degree), 1.0 / (degree + 1),
                  ulps(2.0 + n))
          << "n " << n << " degree " << degree;
    }
  }
}

TEST(GaussLobatto, ContainsBothEndsExactly) {
  for (int n = 2; n <= 13; ++n) {
    const std::vector<double> points = math::gauss_lobatto_points(n);

    ASSERT_EQ(points.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(points.front(), 0.0) << "n " << n;
    EXPECT_EQ(points.back(), 1.0) << "n " << n;
    EXPECT_TRUE(std::ranges::is_sorted(points)) << "n " << n;
  }
}

}  // namespace
}  // namespace brachisto::testing
