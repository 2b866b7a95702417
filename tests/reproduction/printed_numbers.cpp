// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// When a number agrees with a printed one, and how numbers are printed.

#include "reproduction/printed_numbers.hpp"

#include <gtest/gtest.h>

namespace brachisto::reproduction {
namespace {

PrintedNumber beside(const char* printed, double ours, double error = 0.0) {
  PrintedNumber row;
  row.paper = printed;
  row.ours = {ours, error};
  return row;
}

TEST(ReproductionComparison, AgreesWithinHalfAUnitOfTheLastDigit) {
  EXPECT_TRUE(beside("4.99", 4.9949).agrees());
  EXPECT_TRUE(beside("4.99", 4.9851).agrees());
  EXPECT_FALSE(beside("4.99", 4.9951).agrees());
  EXPECT_FALSE(beside("1.229", 1.22846).agrees());
  EXPECT_TRUE(beside("2.5", 2.508).agrees());
}

TEST(ReproductionComparison, OurOwnErrorCounts) {
  EXPECT_FALSE(beside("4.99", 4.997).agrees());
  EXPECT_TRUE(beside("4.99", 4.997, 0.003).agrees());
}

TEST(ReproductionComparison, ReadsARealMinusSign) {
  // One rounding of numbers of order one.
  EXPECT_NEAR(beside("−1.34", -1.28).difference(), 0.06, 3e-16);
}

TEST(ReproductionComparison, PrintsAsManyDigitsAsAreKnown) {
  EXPECT_EQ(with_error({5.0934444666178, 3e-13}), "5.0934444666178(3)");
  EXPECT_EQ(with_error({4.33012345, 2e-4}), "4.3301(2)");
}

TEST(ReproductionComparison, NeverClaimsMoreThanADoubleHolds) {
  EXPECT_EQ(with_error({2.0, 0.0}), "2.00000000000000(1)");
}

}  // namespace
}  // namespace brachisto::reproduction
