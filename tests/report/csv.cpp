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

// CWE-1236: a spreadsheet computes what begins with = + - @, and looks behind
// a tab or an end of line.
TEST(CsvField, IsNoFormula) {
  EXPECT_EQ(csv_field("=1+1"), "'=1+1");
  EXPECT_EQ(csv_field("+1"), "'+1");
  EXPECT_EQ(csv_field("-pi/6"), "'-pi/6");
  EXPECT_EQ(csv_field("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(csv_field("=HYPERLINK(\"x\",\"y\")"),
            "\"'=HYPERLINK(\"\"x\"\",\"\"y\"\")\"");
  EXPECT_EQ(csv_field("\t=1"), "'\t=1");
  EXPECT_EQ(csv_field("\n=1"), "\"'\n=1\"");
  EXPECT_EQ(csv_field("a=1"), "a=1");
}

}  // namespace
}  // namespace brachisto::report
