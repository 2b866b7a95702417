// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/svg_theme.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "report/figure.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

constexpr Colour kWhite{255.0, 255.0, 255.0}, kBlack{0.0, 0.0, 0.0};

/// WCAG 2.1: 21 of black on white, 4.54 of the grey #767676, which it names as
/// the lightest of AA.
TEST(Contrast, IsThatOfWcag) {
  EXPECT_NEAR(contrast(kBlack, kWhite), 21.0, 1e-12);
  EXPECT_NEAR(contrast({118.0, 118.0, 118.0}, kWhite), 4.54, 0.005);
  EXPECT_EQ(contrast(kWhite, kWhite), 1.0);
}

TEST(DarkGround, KeepsTheContrastOfColours) {
  EXPECT_EQ(on_dark_ground(kWhite), kDarkGround);
  EXPECT_EQ(on_dark_ground(kBlack), kWhite);
  for (double share = 0.0; share <= 1.0; share += 0.0625) {
    const Colour colour = colour_at(share), dark = on_dark_ground(colour);
    // Where there is that much of it.
    const double most = contrast(kWhite, kDarkGround);
    const double wanted =
        std::min(std::max(contrast(colour, kWhite), 3.0), most);
    // A channel is rounded to half a unit, which of dark ones is 3 % of light.
    EXPECT_NEAR(contrast(dark, kDarkGround), wanted, 0.03 * wanted) << share;
  }
}

DrawnFiles drawn(const std::string& commands) {
  return draw({.name = "line",
               .table = "part,x,y\na,0,1\na,1,3\n",
               .commands = commands +
                           "plot data using (column('x')):(column('y')) with "
                           "lines lc rgb '#440154' title 'two  spaces'\n"},
              Format::Svg, nullptr);
}

TEST(Theme, TellsDarkColoursOfGroundLinesAndWords) {
  const DrawnFiles figure = drawn("set border lc rgb '#333333'\n");
  ASSERT_EQ(figure.missing, "");
  const std::string& svg = figure.files.back().content;

  EXPECT_EQ(testing::xml_flaw(svg), "");
  for (const char* rule :
       {"[fill=\"#ffffff\"] { fill: var(--paper, #15171b); }",
        "='rgb( 68,   1,  84)'] { stroke: #",
        "[color=\"black\"] { color: #ffffff; }"}) {
    EXPECT_NE(svg.find(rule), std::string::npos) << rule;
  }
}

TEST(Theme, KeepsSpacesOfWords) {
  const std::string svg = drawn("").files.back().content;

  EXPECT_NE(svg.find("two  spaces</tspan>"), std::string::npos);
  EXPECT_NE(svg.find("<text xml:space=\"preserve\">"), std::string::npos);
  EXPECT_EQ(svg.find("<text>"), std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
