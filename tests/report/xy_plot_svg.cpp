// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/xy_plot_svg.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/letters.hpp"
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

TEST(XyPlot, GivesTheLabelsOfAFamilyTheRoomTheyNeed) {
  const auto labelled = [](const std::string& key) {
    const SweepTable table = sweep_over(
        {{key, 1.0, 2.0, 2}, {"scene.body.k", 0.0, 1.0, 5}},
        [](const std::vector<double>& at) { return 5.0 + 0.1 * at[1]; });
    XyPlot plot;
    plot.x_column = 1;
    plot.family = 0;
    plot.curves = {{0, 1, 2, 3, 4}, {5, 6, 7, 8, 9}};
    return xy_plot_svg(table, plot, kRange);
  };
  // Left end of a text.
  const auto left = [](const std::string& svg, const std::string& text) {
    const std::size_t tag = svg.rfind("<text x=\"", svg.find(text));
    return std::stod(svg.substr(tag + 9));
  };

  const std::string fits = labelled("solver.limits.iterations");
  EXPECT_LE(left(fits, ">solver.limits.iterations<") + width_of(24, 13.0),
            720.0);

  const std::string cut = labelled("solver.limits.of_the_second.iterations");
  EXPECT_LE(left(cut, ">…of_the_second.iterations<") + width_of(26, 13.0),
            720.0);
}

TEST(XyPlot, CutsAKeyThatIsLongerThanItsAxis) {
  SweepTable table = slope();
  table.columns[0].key = "first." + std::string(80, 'x') + ".the_last_part";

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(count(svg, ">…the_last_part<"), 1u);
}

TEST(XyPlot, NamesAllKeysThatVaryAtTheMinimumInLinesThatFit) {
  SweepTable table = slope();
  const std::vector<double> descending{10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0};
  for (int i = 0; i < 6; ++i) {
    table.columns.push_back(
        {"solver.limits.number_" + std::to_string(i), descending, {}});
  }
  table.columns.push_back({"solver.same", std::vector<double>(11, 7.0), {}});
  XyPlot plot = curve(table);
  plot.joined = false;

  const std::string svg = xy_plot_svg(table, plot, kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "</tspan> = 0, solver.limits.number_0 = 10,<"), 1u);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(count(svg, "solver.limits.number_" + std::to_string(i) + " = 10"),
              1u);
  }
  EXPECT_EQ(count(svg, "solver.same"), 0u);
}

TEST(XyPlot, MarksTheFastestFeasibleSceneAndAFasterInfeasibleOne) {
  SweepTable table = slope();
  table.outcomes[0].feasible = false;

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(count(svg, "class=\"minimum\" fill=\"#000000\""), 1u);
  EXPECT_EQ(count(svg, "class=\"infeasible-minimum\" fill=\"none\""), 1u);
  EXPECT_NE(svg.find("</tspan> = 5.1 at "), std::string::npos);
  EXPECT_NE(svg.find("faster, but infeasible: "), std::string::npos);
  EXPECT_NE(svg.find("</tspan> = 5 at "), std::string::npos);
}

TEST(XyPlot, HasNoOpenMarkerIfAFeasibleSceneIsAsFast) {
  SweepTable table = slope();
  table.outcomes[0].feasible = false;
  table.outcomes[1].tau = table.outcomes[0].tau;

  const std::string svg = xy_plot_svg(table, curve(table), kRange);

  EXPECT_EQ(count(svg, "class=\"minimum\""), 1u);
  EXPECT_EQ(count(svg, "class=\"infeasible-minimum\""), 0u);
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
