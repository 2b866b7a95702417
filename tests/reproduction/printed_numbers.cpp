// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// When a number agrees with a printed one, and how numbers are printed.

#include "reproduction/printed_numbers.hpp"

#include <gtest/gtest.h>

#include "reproduction/page.hpp"

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

TEST(ReproductionComparison, IsMarkdownIfWanted) {
  Reproduction made;
  made.comparisons = {{.place = "Fig. 6",
                       .quantity = "|R_n|",
                       .paper = "4.52",
                       .ours = {4.5106, 1e-4},
                       .unit = "m g"}};
  made.claims = {{"III.A", "It folds.", Verdict::Fails, "It does not."}};

  EXPECT_EQ(numbers_text(made, report::TableForm::Markdown),
            "| quantity      | paper | here      | here − paper      |\n"
            "| ------------- | ----- | --------- | ----------------- |\n"
            "| \\|R_n\\| [m g] | 4.52  | 4.5106(1) | −0.0094 (−0.21 %) |\n"
            "\n"
            "| claim         | statement | evidence     |\n"
            "| ------------- | --------- | ------------ |\n"
            "| does not hold | It folds. | It does not. |\n");
}

TEST(ReproductionComparison, NeverClaimsMoreThanADoubleHolds) {
  EXPECT_EQ(with_error({2.0, 0.0}), "2.00000000000000(1)");
}

}  // namespace
}  // namespace brachisto::reproduction
