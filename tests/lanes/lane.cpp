// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "lanes/lane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brachisto::lanes {
namespace {

template <class Lanes>
class EachWidth : public testing::Test {};
using Widths = testing::Types<Lane<0, 2>, Lane<0, 4>, Lane<0, 8>>;
TYPED_TEST_SUITE(EachWidth, Widths);

TYPED_TEST(EachWidth, HasSinesWithinAnUlpOrTwo) {
  using Number = TypeParam;
  // One ulp of the polynomials, and the rest of n π/2, 2⁻⁸⁶ n, against an
  // angle whose own rounding does not count.
  constexpr double kUlp = std::numeric_limits<double>::epsilon();
  for (int i = -4000; i <= 4000; ++i) {
    const double angle = 0.05 * i + 1e-3;
    Number many(0.0);
    for (std::size_t j = 0; j < Number::kCount; ++j) {
      many.set(j, angle * (1.0 + static_cast<double>(j)));
    }
    const Number s = sin(many), c = cos(many);
    for (std::size_t j = 0; j < Number::kCount; ++j) {
      ASSERT_NEAR(s[j], std::sin(many[j]), 2.0 * kUlp) << many[j];
      ASSERT_NEAR(c[j], std::cos(many[j]), 2.0 * kUlp) << many[j];
    }
  }
}

TEST(Lane, ChoosesAndDecidesForEachByItself) {
  using Number = Lane<0, 8>;
  Number a(1.0);
  a.set(3, std::numeric_limits<double>::quiet_NaN());
  a.set(5, -4.0);

  const Number chosen = where(a > Number(0.0), a, Number(0.0));

  EXPECT_EQ(chosen[0], 1.0);
  EXPECT_EQ(chosen[3], 0.0);
  EXPECT_EQ(chosen[5], 0.0);
  EXPECT_EQ(magnitude(a), 4.0);
  EXPECT_TRUE(any(a < Number(0.0)));
  EXPECT_FALSE(any(a > Number(1.0)));
}

}  // namespace
}  // namespace brachisto::lanes
