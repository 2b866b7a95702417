// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/ocp/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

class Collocation : public ::testing::TestWithParam<int> {
 protected:
  const int p = GetParam();
  const CollocationScheme& scheme = gauss_scheme(p);

  /// p + 1 products of numbers that sum to no more than the norm of a matrix:
  /// 3 for interpolation (the Lebesgue constant), 6 p² for slopes (Markov's
  /// inequality on [0, 1]), 1 for integrals.
  [[nodiscard]] double rounding(double norm) const {
    return ulps(2.0 * (p + 1), norm);
  }

  /// Row `row` of `matrix` times the values of t^power at `abscissae`.
  static double apply(const math::SmallMatrix& matrix, int row,
                      std::span<const double> abscissae, int power) {
    double sum = 0.0;
    for (int j = 0; j < matrix.cols(); ++j) {
      sum += matrix(row, j) *
             std::pow(abscissae[static_cast<std::size_t>(j)], power);
    }
    return sum;
  }
};

TEST_P(Collocation, HasItsNodesAtBothEndsAndItsPointsInside) {
  ASSERT_EQ(scheme.degree, p);
  ASSERT_EQ(scheme.nodes.size(), p + 1);
  ASSERT_EQ(scheme.points.size(), p);
  EXPECT_EQ(scheme.nodes.nodes().front(), 0.0);
  EXPECT_EQ(scheme.nodes.nodes().back(), 1.0);
  EXPECT_GT(scheme.points.nodes().front(), 0.0);
  EXPECT_LT(scheme.points.nodes().back(), 1.0);
}

TEST_P(Collocation, InterpolatesAndDifferentiatesPolynomialsOfItsDegree) {
  for (int power = 0; power <= p; ++power) {
    for (int j = 0; j < p; ++j) {
      const double t = scheme.points.nodes()[static_cast<std::size_t>(j)];
      const double slope = power == 0 ? 0.0 : power * std::pow(t, power - 1);

      EXPECT_NEAR(apply(scheme.interpolation, j, scheme.nodes.nodes(), power),
                  std::pow(t, power), rounding(3.0))
          << "power " << power << " point " << j;
      EXPECT_NEAR(apply(scheme.derivative, j, scheme.nodes.nodes(), power),
                  slope, rounding(6.0 * p * p))
          << "power " << power << " point " << j;
    }
  }
}

TEST_P(Collocation, IntegratesRatesToItsNodes) {
  for (int power = 0; power < p; ++power) {
    for (int n = 0; n <= p; ++n) {
      const double t = scheme.nodes.nodes()[static_cast<std::size_t>(n)];

      EXPECT_NEAR(apply(scheme.integral, n, scheme.points.nodes(), power),
                  std::pow(t, power + 1) / (power + 1), rounding(1.0))
          << "power " << power << " node " << n;
    }
  }
}

TEST_P(Collocation, IntegratesOverTheElementToTwiceItsDegree) {
  for (int power = 0; power < 2 * p; ++power) {
    double sum = 0.0;
    for (std::size_t j = 0; j < scheme.rule.points.size(); ++j) {
      sum += scheme.rule.weights[j] * std::pow(scheme.rule.points[j], power);
    }

    EXPECT_NEAR(sum, 1.0 / (power + 1), rounding(1.0)) << "power " << power;
  }
}

/// The diagonal Padé approximant (p, p) of exp z: N(z)/N(−z) with
/// N = Σ (2p − j)! p! / ((2p)! j! (p − j)!) z^j.
double pade(int p, double z) {
  double numerator = 0.0, denominator = 0.0;
  double coefficient = 1.0;
  for (int j = 0; j <= p; ++j) {
    numerator += coefficient * std::pow(z, j);
    denominator += coefficient * std::pow(-z, j);
    coefficient *= static_cast<double>(p - j) / ((2 * p - j) * (j + 1.0));
  }
  return numerator / denominator;
}

TEST_P(Collocation, IsGaussMethodWhoseStabilityFunctionIsPades) {
  // y' = z y, y(0) = 1 by collocation. That y(1) is the Padé approximant, which
  // agrees with exp z up to z^{2p}, is what order 2p at element ends means.
  for (const double z : {-2.0, -0.3, 0.5, 1.0}) {
    Eigen::MatrixXd matrix(p, p);
    Eigen::VectorXd right(p);
    for (int j = 0; j < p; ++j) {
      right(j) = -(scheme.derivative(j, 0) - z * scheme.interpolation(j, 0));
      for (int n = 1; n <= p; ++n) {
        matrix(j, n - 1) =
            scheme.derivative(j, n) - z * scheme.interpolation(j, n);
      }
    }

    const double y_end = matrix.partialPivLu().solve(right)(p - 1);

    // The inverse of D is an integration, of norm 1, so the condition number
    // is the norm of D.
    EXPECT_NEAR(y_end, pade(p, z), rounding(6.0 * p * p)) << "z " << z;
  }
}

INSTANTIATE_TEST_SUITE_P(Degrees, Collocation,
                         ::testing::Range(1, kLargestDegree + 1),
                         ::testing::PrintToStringParamName());

TEST(CollocationSchemes, AreBuiltOnce) {
  EXPECT_EQ(&gauss_scheme(3), &gauss_scheme(3));
  EXPECT_NE(&gauss_scheme(3), &gauss_scheme(4));
}

TEST(CollocationSchemes, RefuseDegreesThatDoNotExist) {
  EXPECT_THROW(static_cast<void>(gauss_scheme(0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(gauss_scheme(kLargestDegree + 1)),
               std::invalid_argument);
}

TEST(CollocationScheme, EndsWithItsElementAndIntegratesExactly) {
  for (int p = 1; p <= 9; ++p) {
    const CollocationScheme& scheme = radau_scheme(p);

    EXPECT_EQ(scheme.rule.points.back(), 1.0) << p;
    for (int power = 0; power <= 2 * p - 2; ++power) {
      double sum = 0.0;
      for (int j = 0; j < p; ++j) {
        sum += scheme.rule.weights[static_cast<std::size_t>(j)] *
               std::pow(scheme.rule.points[static_cast<std::size_t>(j)], power);
      }
      EXPECT_NEAR(sum, 1.0 / (power + 1), ulps(4.0 * p)) << p;
    }
  }
}

}  // namespace
}  // namespace brachisto::testing
