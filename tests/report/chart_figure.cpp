// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "report/chart.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using testing::xml_flaw;

/// One of everything, with names that have to be escaped.
Chart everything() {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  Chart chart;
  chart.name = "all";
  chart.x.label = "η_m <1>";
  chart.y.label = "k & 'more'";
  chart.equal_scale = chart.y_down = true;
  chart.areas = {{"area, of \"k\" > 0", {{0, 0}, {1, 0}, {1, 1}}, "#e8e8e8"}};
  chart.curves = {{"a, \"b\" & 'c' {d} @e ~f \\g", {{0, 0}, {1, 1}, {2, 0}}},
                  {"η_m", {{0, 0.1}, {kNone, 1}, {1, 0.5}, {2, 0.7}}},
                  {"η_m", {{0, 0.2}, {2, 0.2}}},
                  {"", {{0, 0.3}, {2, 0.3}}}};
  chart.curves[1].stroke = Stroke::DashDotted;
  chart.curves[1].mark = Mark::Diamond;
  chart.curves[2].width = 0.0;
  chart.curves[2].mark = Mark::Cross;
  chart.rounds = {{{1.0, 0.5}, 0.3, Datum{1.1, 0.4}}};
  chart.sketches = {{{0.5, 0.5}, 20.0, {{0.5, 0.5}}, {1.0}, "a <ring>"}};
  chart.notes = {{{1.5, 0.5}, "note & 'τ'", Mark::Disc, -8.0, -8.0}};
  return chart;
}

std::string svg_of(const Chart& chart) {
  const DrawnFiles drawn = draw(chart_figure(chart), Format::Svg, nullptr);
  EXPECT_EQ(drawn.missing, "");
  return drawn.files.back().content;
}

TEST(ChartFigure, OfEverythingIsDrawnWithItsWords) {
  const std::string svg = svg_of(everything());

  EXPECT_EQ(xml_flaw(svg), "");
  for (const char* words : {"a, \"b\" &amp; 'c' {d} @e ~f \\g", "area, of",
                            "a &lt;ring", "note &amp; 'τ'", "k &amp; 'more'"}) {
    EXPECT_NE(svg.find(words), std::string::npos) << words;
  }
}

TEST(ChartFigure, IsAFrameWithoutCurves) {
  Chart chart;
  chart.name = "empty";

  EXPECT_EQ(xml_flaw(svg_of(chart)), "");
}

TEST(ChartFigure, HasLogarithmicSides) {
  Chart chart;
  chart.name = "order";
  chart.x.scale = chart.y.scale = Scale::Logarithmic;
  chart.curves = {{"", {{1e-12, 1e-3}, {1e-2, 10.0}}}};

  EXPECT_EQ(xml_flaw(svg_of(chart)), "");
}

TEST(ChartFigure, HasATableWithARowForEachPoint) {
  Chart chart;
  chart.curves = {{"η_m", {{0, 1}}}, {"η_m", {{0, 2}}}, {"", {{0, 3}}}};
  chart.curves.push_back({.name = "named", .points = {{0, 4}}, .id = "own"});

  EXPECT_EQ(chart_figure(chart).table,
            "part,x,y\nηm,0,1\nηm (2),0,2\ncurve,0,3\nown,0,4\n");
}

TEST(ChartFigure, NamesCurvesThatLookTheSameOnce) {
  Chart chart;
  chart.curves = {{"one", {{0, 1}}}, {"one", {{1, 2}}}, {"two", {{1, 2}}}};
  const std::string commands = chart_figure(chart).commands;
  const std::size_t first = commands.find("title 'one'");

  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(commands.find("title 'one'", first + 1), std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
