// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/jet.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "support/observed_order.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using Jet = math::Jet2<double, 2>;

/// Value, f_x, f_y, f_xx, f_xy, f_yy.
using Derivatives = std::array<double, 6>;

Derivatives all(const Jet& jet) {
  return {jet.value,
          jet.gradient[0],
          jet.gradient[1],
          jet.hessian[Jet::pair(0, 0)],
          jet.hessian[Jet::pair(1, 0)],
          jet.hessian[Jet::pair(1, 1)]};
}

void expect_derivatives(const char* what, const Jet& jet,
                        const Derivatives& expected) {
  const Derivatives got = all(jet);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // A handful of operations on numbers of that size.
    EXPECT_NEAR(got[i], expected[i], ulps(8.0, 1.0 + std::abs(expected[i])))
        << what << ", entry " << i;
  }
}

constexpr double kX = 0.7, kY = -1.3;

struct Jet2Operations : ::testing::Test {
  Jet x = Jet::variable(kX, 0);
  Jet y = Jet::variable(kY, 1);
};

TEST_F(Jet2Operations, SumsAndDifferences) {
  expect_derivatives("x + y", x + y, {kX + kY, 1.0, 1.0, 0.0, 0.0, 0.0});
  expect_derivatives("x − y", x - y, {kX - kY, 1.0, -1.0, 0.0, 0.0, 0.0});
  expect_derivatives("−x", -x, {-kX, -1.0, 0.0, 0.0, 0.0, 0.0});
  expect_derivatives("x + 2", x + 2.0, {kX + 2.0, 1.0, 0.0, 0.0, 0.0, 0.0});
  expect_derivatives("2 − y", 2.0 - y, {2.0 - kY, 0.0, -1.0, 0.0, 0.0, 0.0});
}

TEST_F(Jet2Operations, Products) {
  expect_derivatives("x y", x * y, {kX * kY, kY, kX, 0.0, 1.0, 0.0});
  expect_derivatives(
      "x x y", x * x * y,
      {kX * kX * kY, 2.0 * kX * kY, kX * kX, 2.0 * kY, 2.0 * kX, 0.0});
  expect_derivatives("3 x", 3.0 * x, {3.0 * kX, 3.0, 0.0, 0.0, 0.0, 0.0});
}

TEST_F(Jet2Operations, Quotients) {
  expect_derivatives("x / y", x / y,
                     {kX / kY, 1.0 / kY, -kX / (kY * kY), 0.0, -1.0 / (kY * kY),
                      2.0 * kX / (kY * kY * kY)});
}

TEST_F(Jet2Operations, SineAndCosine) {
  const double s = std::sin(kX * kY), c = std::cos(kX * kY);

  expect_derivatives(
      "sin(x y)", sin(x * y),
      {s, kY * c, kX * c, -kY * kY * s, c - kX * kY * s, -kX * kX * s});
  expect_derivatives(
      "cos(x y)", cos(x * y),
      {c, -kY * s, -kX * s, -kY * kY * c, -s - kX * kY * c, -kX * kX * c});
}

TEST_F(Jet2Operations, SquareRoot) {
  // ρ = √(x² + y²): ρ_x = x/ρ, ρ_xx = y²/ρ³, ρ_xy = −x y/ρ³, ρ_yy = x²/ρ³.
  const double rho = std::hypot(kX, kY), cube = rho * rho * rho;

  expect_derivatives("ρ", sqrt(x * x + y * y),
                     {rho, kX / rho, kY / rho, kY * kY / cube, -kX * kY / cube,
                      kX * kX / cube});
}

TEST_F(Jet2Operations, Exponential) {
  const double e = std::exp(kX * kY);

  expect_derivatives(
      "exp(x y)", exp(x * y),
      {e, kY * e, kX * e, kY * kY * e, (1.0 + kX * kY) * e, kX * kX * e});
}

TEST_F(Jet2Operations, Logarithm) {
  // ln(x² + y²) = 2 ln ρ.
  const double square = kX * kX + kY * kY, fourth = square * square;

  expect_derivatives(
      "ln ρ²", log(x * x + y * y),
      {std::log(square), 2.0 * kX / square, 2.0 * kY / square,
       2.0 * (kY * kY - kX * kX) / fourth, -4.0 * kX * kY / fourth,
       2.0 * (kX * kX - kY * kY) / fourth});
}

TEST_F(Jet2Operations, Arctangent) {
  // The polar angle of (x, y), x > 0.
  const double square = kX * kX + kY * kY, fourth = square * square;

  expect_derivatives(
      "arctan y/x", atan(y / x),
      {std::atan(kY / kX), -kY / square, kX / square, 2.0 * kX * kY / fourth,
       (kY * kY - kX * kX) / fourth, -2.0 * kX * kY / fourth});
}

TEST_F(Jet2Operations, AssignmentsInPlace) {
  Jet sum = x;
  sum += y;
  Jet difference = x;
  difference -= y;

  EXPECT_EQ(all(sum), all(x + y));
  EXPECT_EQ(all(difference), all(x - y));
}

TEST(Jet2, AConstantHasNoDerivatives) {
  EXPECT_EQ(all(Jet(4.0)), (Derivatives{4.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(all(Jet()), Derivatives{});
}

TEST(Jet2, StoresTheLowerTriangleRowByRow) {
  using Three = math::Jet2<double, 3>;

  EXPECT_EQ(Three::kPairs, 6);
  EXPECT_EQ(Three::pair(0, 0), 0U);
  EXPECT_EQ(Three::pair(1, 0), 1U);
  EXPECT_EQ(Three::pair(1, 1), 2U);
  EXPECT_EQ(Three::pair(2, 0), 3U);
  EXPECT_EQ(Three::pair(2, 2), 5U);
}

template <class Scalar>
Scalar composite(const Scalar& x, const Scalar& y) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  return sin(x * y) / sqrt(x * x + y * y + 1.0L) - cos(x - y * y) * x;
}

TEST(Jet2, IsASecondOrderModelOfACompositeFunction) {
  using LongJet = math::Jet2<long double, 2>;
  constexpr std::uint32_t kSeed = 1;
  Random random(kSeed);
  for (int sample = 0; sample < 20; ++sample) {
    const double x = random.uniform(-2.0, 2.0), y = random.uniform(-2.0, 2.0);
    const double p = random.uniform(0.5, 1.0), q = random.uniform(0.5, 1.0);

    const LongJet jet =
        composite(LongJet::variable(x, 0), LongJet::variable(y, 1));

    // What the model leaves falls as h³.
    std::array<double, 6> steps{}, errors{};
    for (std::size_t level = 0; level < steps.size(); ++level) {
      const long double h = std::ldexp(0.02L, -static_cast<int>(level));
      const long double slope = p * jet.gradient[0] + q * jet.gradient[1];
      const long double curvature =
          p * p * jet.hessian[LongJet::pair(0, 0)] +
          2 * p * q * jet.hessian[LongJet::pair(1, 0)] +
          q * q * jet.hessian[LongJet::pair(1, 1)];
      const long double model = jet.value + h * slope + h * h / 2 * curvature;
      steps[level] = static_cast<double>(h);
      errors[level] = static_cast<double>(
          std::abs(composite<long double>(x + h * p, y + h * q) - model));
    }
    // The next term of the series bends the line by a few h.
    EXPECT_NEAR(observed_order(steps, errors), 3.0, 0.1)
        << "seed " << kSeed << " sample " << sample;
  }
}

}  // namespace
}  // namespace brachisto::testing
