// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/polynomial_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using math::LagrangeBasis;
using math::SmallMatrix;

constexpr int kLargestDegree = 12;

/// A polynomial in powers of t, and its slope.
struct Polynomial {
  std::vector<double> coefficients;

  [[nodiscard]] double value(double t) const {
    double sum = 0.0;
    for (auto c = coefficients.rbegin(); c != coefficients.rend(); ++c) {
      sum = sum * t + *c;
    }
    return sum;
  }
  [[nodiscard]] double slope(double t) const {
    double sum = 0.0;
    for (std::size_t i = coefficients.size() - 1; i > 0; --i) {
      sum = sum * t + static_cast<double>(i) * coefficients[i];
    }
    return sum;
  }
};

LagrangeBasis lobatto_basis(int degree) {
  return LagrangeBasis(math::gauss_lobatto_points(degree + 1));
}

/// Coefficients below one make values below p + 1 and slopes below p (p + 1);
/// p + 1 products of p factors each are summed, with weights whose absolute sum
/// is below 3 at Lobatto points (the Lebesgue constant), and below 3·2p² for
/// slopes (Markov).
double value_rounding(int p) {
  return ulps(2.0 * (p + 1), 3.0 * (p + 1));
}
double slope_rounding(int p) {
  return ulps(2.0 * (p + 1), 3.0 * 2.0 * p * p * (p + 1));
}

TEST(LagrangeBasis, ReproducesPolynomialsAndTheirSlopes) {
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int p = 1; p <= kLargestDegree; ++p) {
    const LagrangeBasis basis = lobatto_basis(p);
    std::vector<double> values(static_cast<std::size_t>(p) + 1);
    std::vector<double> slopes(values.size());
    for (int sample = 0; sample < 50; ++sample) {
      const Polynomial f{random.vector(p + 1, -1.0, 1.0)};
      const double t = random.uniform(0.0, 1.0);

      basis.evaluate(t, values, slopes);

      double value = 0.0, slope = 0.0;
      for (std::size_t j = 0; j < values.size(); ++j) {
        value += values[j] * f.value(basis.nodes()[j]);
        slope += slopes[j] * f.value(basis.nodes()[j]);
      }
      EXPECT_NEAR(value, f.value(t), value_rounding(p))
          << "seed " << kSeed << " degree " << p << " t " << t;
      EXPECT_NEAR(slope, f.slope(t), slope_rounding(p))
          << "seed " << kSeed << " degree " << p << " t " << t;
    }
  }
}

TEST(LagrangeBasis, IsTheUnitMatrixAtItsNodes) {
  for (int p = 1; p <= kLargestDegree; ++p) {
    const LagrangeBasis basis = lobatto_basis(p);

    const SmallMatrix matrix = basis.values_at(basis.nodes());

    ASSERT_EQ(matrix.rows(), p + 1);
    ASSERT_EQ(matrix.cols(), p + 1);
    for (int i = 0; i <= p; ++i) {
      for (int j = 0; j <= p; ++j) {
        if (i == j) {
          // p products, once up and once down.
          EXPECT_NEAR(matrix(i, j), 1.0, ulps(p)) << "degree " << p;
        } else {
          EXPECT_EQ(matrix(i, j), 0.0) << "degree " << p;
        }
      }
    }
  }
}

TEST(LagrangeBasis, SumsToOneAndItsSlopesToZero) {
  for (int p = 1; p <= kLargestDegree; ++p) {
    const LagrangeBasis basis = lobatto_basis(p);
    const std::vector<double> points{0.0, 0.013, 0.4, 0.77, 1.0};

    const SmallMatrix values = basis.values_at(points);
    const SmallMatrix slopes = basis.slopes_at(points);

    for (int i = 0; i < values.rows(); ++i) {
      double sum = 0.0;
      long double slope_sum = 0.0L;  // of a few doubles of like size: exact
      for (int j = 0; j <= p; ++j) {
        sum += values(i, j);
        slope_sum += slopes(i, j);
      }
      EXPECT_NEAR(sum, 1.0, value_rounding(p)) << "degree " << p;
      EXPECT_EQ(slope_sum, 0.0L) << "degree " << p;
    }
  }
}

TEST(LagrangeBasis, KnowsThePolynomialThatVanishesAtItsNodes) {
  // t^(p+1) is interpolated but for Π (t − t_j), and the divided difference of
  // t^p is 1.
  for (int p = 1; p <= kLargestDegree; ++p) {
    const LagrangeBasis basis = lobatto_basis(p);
    std::vector<double> values(static_cast<std::size_t>(p) + 1);
    for (const double t : {0.013, 0.4, 0.77, 1.0}) {
      basis.evaluate(t, values);
      double interpolated = 0.0, leading = 0.0, weights = 0.0;
      for (std::size_t j = 0; j < values.size(); ++j) {
        const double node = basis.nodes()[j];
        interpolated += values[j] * std::pow(node, p + 1);
        leading += basis.weights()[j] * std::pow(node, p);
        weights += std::abs(basis.weights()[j]);
      }
      EXPECT_NEAR(std::pow(t, p + 1) - interpolated, basis.node_polynomial(t),
                  value_rounding(p))
          << "degree " << p << " t " << t;
      EXPECT_NEAR(leading, 1.0, ulps(p + 2.0, weights)) << "degree " << p;
    }
  }
}

TEST(LagrangeBasis, OfOneNodeIsConstant) {
  const LagrangeBasis basis({0.5});
  std::vector<double> value(1), slope(1);

  basis.evaluate(0.9, value, slope);

  EXPECT_EQ(value[0], 1.0);
  EXPECT_EQ(slope[0], 0.0);
}

TEST(LagrangeBasis, MatricesHaveOneRowPerPoint) {
  const LagrangeBasis basis({0.0, 0.25, 1.0});
  const std::vector<double> points{0.1, 0.9};
  std::vector<double> row(3), ignored(3);

  const SmallMatrix values = basis.values_at(points);
  const SmallMatrix slopes = basis.slopes_at(points);

  ASSERT_EQ(values.rows(), 2);
  ASSERT_EQ(values.cols(), 3);
  for (int i = 0; i < 2; ++i) {
    basis.evaluate(points[static_cast<std::size_t>(i)], row);
    for (int j = 0; j < 3; ++j) {
      EXPECT_EQ(values(i, j), row[static_cast<std::size_t>(j)]);
    }
    basis.evaluate(points[static_cast<std::size_t>(i)], ignored, row);
    for (int j = 0; j < 3; ++j) {
      EXPECT_NEAR(slopes(i, j), row[static_cast<std::size_t>(j)],
                  slope_rounding(2));
    }
  }
}

TEST(SmallMatrix, StartsAtZeroAndKeepsItsEntriesApart) {
  SmallMatrix matrix(2, 3);
  EXPECT_EQ(matrix(1, 2), 0.0);

  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) matrix(i, j) = 10.0 * i + j;
  }

  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_EQ(matrix(i, j), 10.0 * i + j);
  }
}

}  // namespace
}  // namespace brachisto::testing
