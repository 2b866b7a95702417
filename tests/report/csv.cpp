// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/csv.hpp"

#include <gtest/gtest.h>

namespace brachisto::report {
namespace {

TEST(CsvField, IsTheTextItselfWhereItCanBe) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("two words; θ_m = −30°"), "two words; θ_m = −30°");
}

TEST(CsvField, IsQuotedWhereItWouldEndTheFieldOrTheLine) {
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_field("a\r"), "\"a\r\"");
}

TEST(CsvField, DoublesQuotes) {
  EXPECT_EQ(csv_field("\""), "\"\"\"\"");
  EXPECT_EQ(csv_field("the \"rail\", bent"), "\"the \"\"rail\"\", bent\"");
}

}  // namespace
}  // namespace brachisto::report
