// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/rich_text.hpp"

#include <gtest/gtest.h>

#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::xml_flaw;

constexpr std::string_view kHostile = "a_b < \"c\" & 'd' \\ ~e @f {g} ^";

TEST(RichText, LowersAndRaisesALetterOrAGroup) {
  EXPECT_EQ(html_words("η_m = 10^{−6}"), "η<sub>m</sub> = 10<sup>−6</sup>");
  EXPECT_EQ(html_words("x_β^2"), "x<sub>β</sub><sup>2</sup>");
  EXPECT_EQ(html_words("plain"), "plain");
}

TEST(RichText, KeepsMarksThatHaveNothingToLower) {
  EXPECT_EQ(plain_words("a_"), "a_");
  EXPECT_EQ(plain_words("a_{b"), "a{b");
  EXPECT_EQ(plain_words("a_{}b"), "ab");
}

TEST(RichText, HasWordsWithoutMarks) {
  EXPECT_EQ(plain_words("R_n [m g], 10^{-6}"), "Rn [m g], 10-6");
}

TEST(RichText, KeepsMarksAfterABackslash) {
  const std::string source = "a_b^c \\ {d}";
  EXPECT_EQ(plain_words(as_rich_text(source)), source);
  EXPECT_EQ(html_words("k\\_1 = η_m"), "k_1 = η<sub>m</sub>");
}

TEST(RichText, IsEscapedForXml) {
  EXPECT_EQ(xml_flaw("<t>" + html_words(kHostile) + "</t>"), "");
}

TEST(RichText, IsEscapedForGnuplot) {
  EXPECT_EQ(gnuplot_words("R_n {x} @ 'y' 10^{-6} \\ & ~\n"),
            "R_{n} \\{x\\} \\@ ''y'' 10^{-6} \\\\ \\& \\~ ");
}

}  // namespace
}  // namespace brachisto::report
