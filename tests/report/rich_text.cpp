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

/// Sum of the shifts of a text.
double sum_of_shifts(const std::string& svg) {
  double sum = 0.0;
  for (std::size_t at = svg.find("dy=\""); at != std::string::npos;
       at = svg.find("dy=\"", at + 1)) {
    sum += std::stod(svg.substr(at + 4));
  }
  return sum;
}

TEST(RichText, OfSvgComesBackToTheLine) {
  for (const char* source : {"η_m", "η_m = 1", "k = 1 − η_m^2", "10^{−6} m"}) {
    EXPECT_EQ(sum_of_shifts(svg_words(source)), 0.0) << source;
  }
}

TEST(RichText, IsEscapedForXml) {
  EXPECT_EQ(xml_flaw("<t>" + svg_words(kHostile) + "</t>"), "");
  EXPECT_EQ(xml_flaw("<t>" + html_words(kHostile) + "</t>"), "");
}

TEST(RichText, IsEscapedForGnuplot) {
  EXPECT_EQ(gnuplot_words("R_n {x} @ 'y' 10^{-6} \\ & ~\n"),
            "R_{n} \\{x\\} \\@ ''y'' 10^{-6} \\\\ \\& \\~ ");
}

}  // namespace
}  // namespace brachisto::report
