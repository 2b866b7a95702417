// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/roots.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace brachisto::testing {
namespace {

using math::find_root;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(FindRoot, FindsTheRootToTheLastBit) {
  const auto f = [](double x) { return std::cos(x) - x; };

  const double root = find_root(f, 0.0, 1.0);

  EXPECT_DOUBLE_EQ(root, 0.73908513321516064166);  // Dottie's number
  // No neighbour is on the same side and closer.
  const double below = f(std::nextafter(root, -kInfinity));
  const double above = f(std::nextafter(root, kInfinity));
  EXPECT_GE(below, 0.0);
  EXPECT_LE(above, 0.0);
}

TEST(FindRoot, WorksForRisingAndFallingFunctions) {
  const auto rising = [](double x) { return x * x - 2.0; };
  const auto falling = [](double x) { return 2.0 - x * x; };

  EXPECT_DOUBLE_EQ(find_root(rising, 1.0, 2.0), std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(find_root(falling, 1.0, 2.0), std::sqrt(2.0));
}

TEST(FindRoot, KeepsRelativeAccuracyOfASmallRoot) {
  const auto f = [](double x) { return std::expm1(x) - 1e-12; };

  EXPECT_DOUBLE_EQ(find_root(f, -1.0, 1.0), std::log1p(1e-12));
}

TEST(FindRoot, CopesWithFlatAndSteepFunctions) {
  const auto flat = [](double x) { return std::pow(x - 0.3, 5); };
  const auto steep = [](double x) { return std::atan(1e12 * (x - 0.3)); };

  // (x − 0.3)⁵ underflows to zero within 1e-65 of its root.
  EXPECT_DOUBLE_EQ(find_root(flat, 0.0, 1.0), 0.3);
  EXPECT_DOUBLE_EQ(find_root(steep, 0.0, 1.0), 0.3);
}

TEST(FindRoot, AcceptsARootAtAnEnd) {
  const auto f = [](double x) { return x - 1.0; };

  EXPECT_EQ(find_root(f, 1.0, 2.0), 1.0);
  EXPECT_EQ(find_root(f, 0.0, 1.0), 1.0);
}

TEST(FindRoot, RefusesAnIntervalWithoutChangeOfSign) {
  const auto f = [](double x) { return x * x + 1.0; };

  EXPECT_THROW(static_cast<void>(find_root(f, -1.0, 1.0)), std::domain_error);
}

TEST(FindRoot, BelievesWhatIsKnownOfTheEnds) {
  // Rounding gives f the wrong sign at the end where it is all but zero.
  const auto f = [](double x) { return x + 1e-17; };
  EXPECT_THROW(static_cast<void>(find_root(f, 0.0, 1.0)), std::domain_error);

  const double root = find_root(f, 0.0, 1.0, -1e-17, 1.0);

  EXPECT_NEAR(root, 0.0, 1e-16);
}

}  // namespace
}  // namespace brachisto::testing
