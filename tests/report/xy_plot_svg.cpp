// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/xy_plot_svg.hpp"

#include <gtest/gtest.h>

#include <string>

#include "report/sweep_tables.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::count;
using brachisto::testing::fail;
using brachisto::testing::sweep_over;
using brachisto::testing::xml_flaw;

constexpr ValueRange kRange{5.0, 6.0};

SweepTable slope() {
  return sweep_over({{"scene.body.k", 0.0, 1.0, 11}},
                    [](const std::vector<double>& at) { return 5.0 + at[0]; });
}

XyPlot curve(const SweepTable& table) {
  XyPlot plot;
  plot.curves = {all_scenes(table)};
  return plot;
}

TEST(XyPlot, DrawsACurveWithADotPerScene) {
  const SweepTable table = slope();

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "class=\"curve\""), 1u);
  EXPECT_EQ(count(svg, "h0"), 11u);
  EXPECT_EQ(count(svg, "class=\"minimum\""), 1u);
}

TEST(XyPlot, HasAGapAndACrossWhereScenesFailed) {
  SweepTable table = slope();
  fail(table, 4);
  fail(table, 5);

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(count(svg, "class=\"curve\""), 2u);
  EXPECT_EQ(count(svg, "class=\"failed\""), 2u);
  EXPECT_EQ(count(svg, "h0"), 9u);
  EXPECT_NE(svg.find("no verified result (2)"), std::string::npos);
}

TEST(XyPlot, HasAGapButNoCrossWhereScenesAreMissing) {
  SweepTable table = slope();
  table.outcomes[4] = {};

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(count(svg, "class=\"curve\""), 2u);
  EXPECT_EQ(count(svg, "class=\"failed\""), 0u);
}

TEST(XyPlot, LabelsEachCurveOfAFamily) {
  SweepTable table = sweep_over(
      {{"scene.finish.L", 1.0, 4.0, 4}, {"scene.body.k", 0.0, 1.0, 5}},
      [](const std::vector<double>& at) { return 5.0 + 0.1 * at[0] * at[1]; });
  XyPlot plot;
  plot.x_column = 1;
  plot.family = 0;
  plot.curves = {{0, 1, 2, 3, 4},
                 {5, 6, 7, 8, 9},
                 {10, 11, 12, 13, 14},
                 {15, 16, 17, 18, 19}};

  const std::string svg = xy_plot_svg(table, plot, kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "class=\"curve\""), 4u);
  for (const std::string label : {">1 m<", ">2 m<", ">3 m<", ">4 m<"}) {
    EXPECT_EQ(count(svg, label), 1u) << label;
  }
}

TEST(XyPlot, TakesWordsAsCategoriesAndEscapesThem) {
  SweepTable table = slope();
  for (std::size_t i = 0; i < 11; ++i) {
    table.columns[0].words.emplace_back(i % 2 == 0 ? "a < b" : "\"x\" & y");
  }
  XyPlot plot = curve(table);
  plot.joined = false;

  const std::string svg = xy_plot_svg(table, plot, kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_NE(svg.find(">a &lt; b<"), std::string::npos);
  EXPECT_NE(svg.find(">&quot;x&quot; &amp; y<"), std::string::npos);
  EXPECT_EQ(count(svg, "class=\"curve\""), 0u);
}

TEST(XyPlot, SlantsWordsThatAreMany) {
  SweepTable table = slope();
  for (int i = 0; i < 11; ++i) {
    table.columns[0].words.push_back("a word that is too long " +
                                     std::to_string(i));
  }

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "rotate(-40"), 11u);
  EXPECT_EQ(count(svg, "a word that i…"), 11u);
}

TEST(XyPlot, OfFailuresOnlyHasCrossesOnly) {
  SweepTable table = slope();
  for (std::size_t i = 0; i < 11; ++i) fail(table, i);

  const std::string svg = xy_plot_svg(table, curve(table), {0.0, 1.0});

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "class=\"failed\""), 11u);
  EXPECT_EQ(count(svg, "class=\"minimum\""), 0u);
}

}  // namespace
}  // namespace brachisto::report
