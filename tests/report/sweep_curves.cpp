// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "report/sweep_pictures.hpp"
#include "report/sweep_plots.hpp"
#include "report/sweep_tables.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::count;
using brachisto::testing::fail;
using brachisto::testing::list_over;
using brachisto::testing::svg_of;
using brachisto::testing::sweep_over;
using brachisto::testing::xml_flaw;

constexpr Extent kSlopeRange{5.0, 6.0};

SweepTable slope() {
  return sweep_over({{"scene.body.k", 0.0, 1.0, 11}},
                    [](const std::vector<double>& at) { return 5.0 + at[0]; });
}

XyPlot curve(const SweepTable& table) {
  XyPlot plot;
  plot.name = "curve";
  plot.curves = {all_scenes(table)};
  return plot;
}

/// Rows of the table that begin so.
std::size_t rows(const Figure& figure, const std::string& part) {
  return count(figure.table, "\n" + part + ",");
}

/// Lines of the curve "curve", of more than one point each.
std::size_t lines(const Figure& figure) {
  std::istringstream table(figure.table);
  std::string row;
  std::size_t found = 0, length = 0;
  while (std::getline(table, row)) {
    const bool point =
        row.starts_with("curve,") && row.find("nan") == std::string::npos;
    length = point ? length + 1 : 0;
    found += length == 2;
  }
  return found;
}

TEST(XyFigure, IsACurveWithARowPerScene) {
  const SweepTable table = slope();

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_EQ(lines(figure), 1u);
  EXPECT_EQ(rows(figure, "curve"), 11u);
  EXPECT_NE(figure.table.find("curve,0.3,5.3\n"), std::string::npos);
  EXPECT_NE(svg_of(figure).find("minimum of the grid: τ = 5.0000000 at k = 0"),
            std::string::npos);
}

TEST(XyFigure, HasAGapAndACrossWhereScenesFailed) {
  SweepTable table = slope();
  fail(table, 4);
  fail(table, 5);

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_EQ(lines(figure), 2u);
  EXPECT_EQ(rows(figure, "failed"), 2u);
  EXPECT_NE(svg_of(figure).find("no verified result (2)"), std::string::npos);
}

TEST(XyFigure, HasAGapButNoCrossWhereScenesAreMissing) {
  SweepTable table = slope();
  table.outcomes[5] = {};

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_EQ(lines(figure), 2u);
  EXPECT_EQ(rows(figure, "failed"), 0u);
}

TEST(XyFigure, IsNotJoinedAcrossAJump) {
  const SweepTable table = sweep_over(
      {{"scene.body.k", 0.0, 1.0, 12}}, [](const std::vector<double>& at) {
        return at[0] < 0.5 ? 5.0 + 0.1 * at[0] : 6.0;
      });

  EXPECT_EQ(lines(xy_figure(table, curve(table), kSlopeRange)), 2u);
}

/// A line between two scenes of a parabola is out by an eighth of the second
/// difference, which must not be more than 2 % of the axis.
TEST(XyFigure, IsJoinedWhereItIsResolved) {
  const auto parabola = [](double height) {
    const SweepTable table = sweep_over(
        {{"scene.body.k", 0.0, 4.0, 5}}, [&](const std::vector<double>& at) {
          return 5.0 + height * at[0] * at[0] / 2.0;
        });
    return lines(xy_figure(table, curve(table), {5.0, 6.0}));
  };

  EXPECT_EQ(parabola(0.9 * 0.16), 1u);
  EXPECT_EQ(parabola(1.1 * 0.16), 0u);
}

TEST(XyFigure, NamesEachCurveOfAFamily) {
  const SweepTable table = sweep_over(
      {{"scene.finish.L", 1.0, 4.0, 4}, {"scene.body.k", 0.0, 1.0, 5}},
      [](const std::vector<double>& at) { return 5.0 + 0.1 * at[0] * at[1]; });
  XyPlot plot;
  plot.name = "family";
  plot.x_column = 1;
  plot.family = 0;
  plot.curves = {{0, 1, 2, 3, 4},
                 {5, 6, 7, 8, 9},
                 {10, 11, 12, 13, 14},
                 {15, 16, 17, 18, 19}};

  const Figure figure = xy_figure(table, plot, kSlopeRange);

  const std::string svg = svg_of(figure);
  for (const std::string name : {"L = 1 m", "L = 2 m", "L = 3 m", "L = 4 m"}) {
    EXPECT_EQ(rows(figure, name), 5u) << name;
    EXPECT_GE(count(svg, ">" + name + "<"), 1u) << name;
  }
}

TEST(XyFigure, NamesWhatIsFixed) {
  SweepTable table = slope();
  table.constants = {{"scene.finish.L", 3.0}, {"scene.body.theta_m", 0.5}};
  table.columns.push_back({"scene.a_b", std::vector<double>(11, 7.0), {}});

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_EQ(figure.title, "τ against k: scene.a_b = 7, L = 3 m, θm = 28.6479°");
  EXPECT_NE(svg_of(figure).find("<title>" + figure.title + "</title>"),
            std::string::npos);
}

TEST(XyFigure, CutsAKeyThatIsLongerThanItsAxis) {
  SweepTable table = slope();
  table.columns[0].key = "first." + std::string(80, 'x') + ".the_last_part";

  EXPECT_NE(svg_of(xy_figure(table, curve(table), kSlopeRange))
                .find("…the_last_part<"),
            std::string::npos);
}

TEST(XyFigure, MarksTheFastestFeasibleSceneAndAFasterInfeasibleOne) {
  SweepTable table = slope();
  table.outcomes[0].feasible = false;

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_NE(figure.table.find("\nminimum,0.1,5.1\n"), std::string::npos);
  EXPECT_NE(figure.table.find("\ninfeasible minimum,0,5\n"), std::string::npos);
  EXPECT_NE(figure.table.find("\ninfeasible,0,5\n"), std::string::npos);
  EXPECT_NE(svg_of(figure).find("less, but infeasible: τ = 5.0000000 at"),
            std::string::npos);
}

TEST(XyFigure, HasNoMarkForAnInfeasibleSceneIfAFeasibleOneIsAsFast) {
  SweepTable table = slope();
  table.outcomes[0].feasible = false;
  table.outcomes[1].tau = table.outcomes[0].tau;

  const Figure figure = xy_figure(table, curve(table), kSlopeRange);

  EXPECT_EQ(rows(figure, "minimum"), 1u);
  EXPECT_EQ(rows(figure, "infeasible minimum"), 0u);
}

TEST(XyFigure, TakesWordsAsCategoriesAndEscapesThem) {
  SweepTable table = slope();
  for (std::size_t i = 0; i < 11; ++i) {
    table.columns[0].words.emplace_back(i % 2 == 0 ? "a < b" : "\"x\" & 'y_z'");
  }
  XyPlot plot = curve(table);
  plot.joined = false;

  const Figure figure = xy_figure(table, plot, kSlopeRange);

  const std::string svg = svg_of(figure);
  EXPECT_NE(svg.find(">a &lt; b<"), std::string::npos);
  EXPECT_NE(svg.find("\"x\" &amp; 'y_z'<"), std::string::npos);
  EXPECT_EQ(figure.commands.find("with lines"), std::string::npos);
}

TEST(XyFigure, CutsWordsThatAreMany) {
  SweepTable table = slope();
  for (int i = 0; i < 11; ++i) {
    table.columns[0].words.push_back("a word that is too long " +
                                     std::to_string(i));
  }

  EXPECT_EQ(count(svg_of(xy_figure(table, curve(table), kSlopeRange)),
                  "a word that is to…"),
            11u);
}

TEST(XyFigure, OfFailuresOnlyHasCrossesOnly) {
  SweepTable table = slope();
  for (std::size_t i = 0; i < 11; ++i) fail(table, i);

  const Figure figure = xy_figure(table, curve(table), {0.0, 1.0});

  EXPECT_EQ(rows(figure, "failed"), 11u);
  EXPECT_EQ(rows(figure, "minimum"), 0u);
  EXPECT_EQ(svg_of(figure).find("minimum of"), std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
