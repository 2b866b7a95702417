// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sines of one angle after the other against those of fifty digits.

#include "math/nearby_sines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/rounding.hpp"

namespace brachisto::math {
namespace {

using testing::Wide;

/// In a power of two: the bound that is derived beside the class.
const long double kBound = std::ldexp(1.0L, -63);

double off(long double got, const Wide& exact) {
  return static_cast<double>(abs(Wide(got) - exact));
}

TEST(NearbySines, KeepToTheirBoundHoweverManyThereAre) {
  // Of narrow steps thousands follow one anchor, of wide ones none.
  for (const long double step : {3e-5L, 0.7e-3L, 0.0123L, 0.2L}) {
    NearbySines sines;
    for (int i = 0; i < 20000; ++i) {
      const long double angle = -0.3L + step * i;
      const auto [sine, cosine] = sines.at(angle);
      ASSERT_LE(off(sine, sin(Wide(angle))), kBound) << step << ' ' << i;
      ASSERT_LE(off(cosine, cos(Wide(angle))), kBound) << step << ' ' << i;
    }
  }
}

TEST(NearbySines, AreRelativelyAsGoodNextToZero) {
  NearbySines sines;
  for (long double angle = 0x1p-7L; angle > 1e-30L; angle *= 0.37L) {
    const Wide exact = sin(Wide(angle));
    EXPECT_LE(off(sines.at(angle).sine, exact),
              kBound * static_cast<long double>(exact));
  }
}

TEST(NearbySines, OfNoNumberAreNone) {
  NearbySines sines;
  EXPECT_TRUE(
      std::isnan(sines.at(std::numeric_limits<long double>::quiet_NaN()).sine));
  EXPECT_LE(off(sines.at(0.5L).cosine, cos(Wide(0.5L))), kBound);
}

}  // namespace
}  // namespace brachisto::math
