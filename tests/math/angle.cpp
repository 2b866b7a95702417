// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/angle.hpp"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

using math::within_a_turn;

TEST(WithinATurn, LeavesWhatIsAsItIs) {
  for (const double angle : {0.0, 1.0, -3.0, 6.28, math::kTurn, -math::kTurn}) {
    EXPECT_EQ(within_a_turn(angle), angle);
  }
}

TEST(WithinATurn, TakesOffTurnsOfTheRealPi) {
  // Fifty digits of π leave twenty-five behind the point here.
  const Wide turn = 2 * boost::math::constants::pi<Wide>();
  for (const double angle : {6.3, -7.0, 1e3, 1e6, -1e6, 123456.789, 1e12, 1e16,
                             -1e22, 628.31853071795865}) {
    const Wide exact = Wide(angle) - turn * round(Wide(angle) / turn);

    const double reduced = within_a_turn(angle);

    // sin, cos and atan2 round, each by half an ulp of a number up to 1, or of
    // the result where that is small.
    EXPECT_NEAR(reduced, exact.convert_to<double>(),
                ulps(2.0, std::abs(exact.convert_to<double>())))
        << angle;
  }
}

}  // namespace
}  // namespace brachisto::testing
