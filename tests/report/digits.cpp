// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/text_table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace brachisto::report {
namespace {

TEST(Digits, EndWhereTheErrorBegins) {
  EXPECT_EQ(with_error(5.093444466598, 4.6e-11), "5.09344446660(5)");
  EXPECT_EQ(with_error(5.093444466598, 9.3e-11), "5.0934444666(1)");
  EXPECT_EQ(with_error(-6.180104, 2e-3), "-6.180(2)");
  EXPECT_EQ(with_error(1.5e-3, 2e-6), "0.001500(2)");
  EXPECT_EQ(within_error(5.09344446660, 3e-5), "5.09344");
  EXPECT_EQ(within_error(5.09344446660, 0.3), "5.1");
}

TEST(Digits, AreNoMoreThanADoubleHas) {
  // A place of 1e-15 in 1234.5 would be invented.
  EXPECT_EQ(with_error(1234.5, 1e-17), "1234.50000000000(1)");
}

TEST(Digits, OfALargeErrorStandBesideIt) {
  EXPECT_EQ(with_error(1234.5, 20.0), "1234 ± 2e+01");
  EXPECT_EQ(within_error(1234.5, 20.0), "1234");
}

// A bound that is rounded to the nearest may be none.
TEST(Digits, OfABoundAreRoundedUp) {
  EXPECT_EQ(at_most(1.41e-12), "1.5e-12");
  EXPECT_EQ(at_most(9.91e-3), "1.0e-02");
  EXPECT_EQ(at_most(0.5), "5.0e-01");
}

TEST(Digits, AreTwelveIfTheErrorIsNotKnown) {
  EXPECT_EQ(with_error(1.0 / 3.0, 0.0), "0.333333333333");
  EXPECT_EQ(with_error(1.0 / 3.0, std::numeric_limits<double>::quiet_NaN()),
            "0.333333333333");
}

}  // namespace
}  // namespace brachisto::report
