// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/text_table.hpp"

#include <gtest/gtest.h>

namespace brachisto::report {
namespace {

TEST(TextTable, AlignsByLetters) {
  EXPECT_EQ(text_table({{"method", "τ", "verdict"},
                        {"a", "—", "no"},
                        {"long name", "1.25", ""}}),
            "method        τ  verdict\n"
            "a             —  no\n"
            "long name  1.25\n");
}

TEST(TextTable, IsMarkdownToo) {
  EXPECT_EQ(markdown_table({{"τ", "verdict"}, {"1.25", ""}}),
            "| τ    | verdict |\n"
            "| ---- | ------- |\n"
            "| 1.25 |         |\n");
}

TEST(TextTable, KeepsBarsAndLinesOfMarkdownInTheirCells) {
  EXPECT_EQ(markdown_table({{"a", "b"}, {"|R|", "one\ntwo"}}),
            "| a     | b       |\n"
            "| ----- | ------- |\n"
            "| \\|R\\| | one two |\n");
  EXPECT_EQ(table({{"a"}}, TableForm::Markdown), markdown_table({{"a"}}));
  EXPECT_EQ(table({{"a"}}, TableForm::Text), text_table({{"a"}}));
}

TEST(TextTable, SaysWhatIsNotThere) {
  EXPECT_EQ(or_dash(std::nullopt), "—");
  EXPECT_EQ(or_dash(7), "7");
  EXPECT_EQ(memory_text(0.0), "—");
  EXPECT_EQ(memory_text(3.8e7), "38 MB");
}

}  // namespace
}  // namespace brachisto::report
