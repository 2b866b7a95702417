// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "report/chart.hpp"
#include "report/charts.hpp"
#include "report/sweep_tables.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::chart_of_everything;
using brachisto::testing::count;
using brachisto::testing::drawn_frame;
using brachisto::testing::drawn_lines;
using brachisto::testing::DrawnFrame;
using brachisto::testing::numbers_of;
using brachisto::testing::sampled;
using brachisto::testing::xml_flaw;

// Coordinates of points are printed with two digits, those of lines with one.
constexpr double kPrinted = 0.005, kPrintedLine = 0.05;

Chart of(Curve curve) {
  Chart chart;
  chart.name = "chart";
  chart.curves = {std::move(curve)};
  return chart;
}

void expect_within(const std::vector<Pixel>& line, const DrawnFrame& frame) {
  const double slack = kPrinted + kPrintedLine;
  for (const Pixel& p : line) {
    EXPECT_GE(p.x, frame.left - slack);
    EXPECT_LE(p.x, frame.right + slack);
    EXPECT_GE(p.y, frame.top - slack);
    EXPECT_LE(p.y, frame.bottom + slack);
  }
}

TEST(ChartSvg, HasEverythingOfAChartOnce) {
  const std::string svg = chart_svg(chart_of_everything());

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "class=\"area\""), 1u);
  EXPECT_EQ(count(svg, "class=\"round\""), 1u);
  EXPECT_EQ(count(svg, "class=\"sketch\""), 1u);
  EXPECT_EQ(count(svg, "class=\"note\""), 1u);
  EXPECT_EQ(count(svg, "class=\"key\""), 4u);  // three curves and the area
  EXPECT_EQ(count(svg, "class=\"curve\""), 3u);
}

TEST(ChartSvg, EscapesItsNames) {
  const std::string svg = chart_svg(chart_of_everything());

  EXPECT_EQ(count(svg, "<title>Everything &lt; all &amp; &quot;more&quot;"),
            1u);
  EXPECT_EQ(count(svg, "a, &quot;b&quot; &amp; 'c' {d} @e ~f \\g"), 1u);
  EXPECT_EQ(count(svg, "a &lt;ring&gt;"), 1u);
  EXPECT_EQ(count(svg, "note &amp; 'τ'"), 1u);
}

TEST(ChartSvg, HasAllPointsWithinTheFrame) {
  const auto wave = [](double x) { return std::sin(7.0 * x) + 1e-3 * x; };
  for (const Scale scale :
       {Scale::Linear, Scale::Logarithmic, Scale::Degrees}) {
    for (const bool equal : {false, true}) {
      Chart chart = of(sampled("", 0.5, 180.0, 2000, wave));
      chart.x.scale = scale;
      chart.equal_scale = equal;

      const std::string svg = chart_svg(chart);

      const auto lines = drawn_lines(svg);
      ASSERT_EQ(lines.size(), 1u);
      expect_within(lines[0], drawn_frame(svg));
    }
  }
}

TEST(ChartSvg, CutsCurvesBeyondItsRanges) {
  Chart chart =
      of(sampled("", -1.0, 1.0, 20001, [](double x) { return 1.0 / x; }));
  chart.y.low = -2.0;
  chart.y.high = 2.0;

  const std::string svg = chart_svg(chart);

  // The two branches, seen where |y| <= 2 and not far beyond.
  const DrawnFrame frame = drawn_frame(svg);
  const auto lines = drawn_lines(svg);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    for (const Pixel& p : line) {
      EXPECT_GT(p.y, frame.top - 20.0);
      EXPECT_LT(p.y, frame.bottom + 20.0);
    }
  }
  EXPECT_NE(svg.find("clip-path=\"url(#clip-chart)\""), std::string::npos);
}

TEST(ChartSvg, ThinsLongCurvesBelowHalfAPixelOnly) {
  // A circle, which has the same distance from its centre everywhere.
  Chart chart = of(sampled("", 0.0, 1.0, 100001, [](double) { return 0.0; }));
  for (std::size_t i = 0; i < chart.curves[0].points.size(); ++i) {
    const double turn =
        2.0 * std::numbers::pi * static_cast<double>(i) / 100000.0;
    chart.curves[0].points[i] = {std::cos(turn), std::sin(turn)};
  }
  chart.equal_scale = true;

  const auto lines = drawn_lines(chart_svg(chart));

  ASSERT_EQ(lines.size(), 1u);
  const std::vector<Pixel>& line = lines[0];
  EXPECT_LT(line.size(), 10000u);
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_LT(std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y),
              1.0);
  }
  EXPECT_NEAR(line.front().x, line.back().x, 2.0 * kPrinted);
  EXPECT_NEAR(line.front().y, line.back().y, 2.0 * kPrinted);
}

TEST(ChartSvg, KeepsASpike) {
  Chart chart = of(sampled("", 0.0, 1.0, 100001,
                           [](double x) { return x == 0.5 ? 1.0 : 0.0; }));

  const auto lines = drawn_lines(chart_svg(chart));

  const auto [low, high] = std::minmax_element(
      lines[0].begin(), lines[0].end(),
      [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
  EXPECT_GT(high->y - low->y, 300.0);
}

TEST(ChartSvg, IsInterruptedWhereACoordinateIsNotFinite) {
  const auto hole = [](double x) { return x > 0.4 && x < 0.6 ? NAN : x; };

  const auto lines =
      drawn_lines(chart_svg(of(sampled("", 0.0, 1.0, 11, hole))));

  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].size() + lines[1].size(), 10u);
}

TEST(ChartSvg, OfEqualScaleDrawsSquaresAsSquares) {
  Chart chart = of({"", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}});
  chart.equal_scale = true;
  for (const double stretch : {0.01, 0.3, 1.0, 5.0, 100.0}) {
    // A second curve that makes the plot wide or high.
    chart.curves.resize(1);
    chart.curves.push_back({"", {{0, 0}, {3.0, 3.0 * stretch}}});

    const std::string svg = chart_svg(chart);

    const std::vector<Pixel> square = drawn_lines(svg).at(0);
    EXPECT_NEAR(square[1].x - square[0].x, square[1].y - square[2].y,
                4.0 * kPrinted)
        << stretch;
    const DrawnFrame frame = drawn_frame(svg);
    EXPECT_GE(frame.bottom - frame.top, 149.0);
    EXPECT_LE(frame.bottom - frame.top, 681.0);
    EXPECT_GE(frame.right - frame.left, 219.0);
    EXPECT_LE(frame.right, 720.0);
  }
}

TEST(ChartSvg, NamesASketchWhereThereIsRoom) {
  Chart chart = of({"", {{0, 0}, {1, 1}}});
  for (const double x : {0.0, 1.0}) {
    chart.sketches = {{{x, 0.5}, 20.0, {}, {1.0}, "ring"}};
    const std::string svg = chart_svg(chart);
    const double place = numbers_of(svg, "class=\"sketch-name\"", "x").at(0);
    const double centre = numbers_of(svg, "class=\"sketch\"", "cx").at(0);
    EXPECT_EQ(place > centre, x == 0.0);
  }
}

TEST(ChartSvg, HasYDownIfAsked) {
  Chart chart = of({"", {{0, 0}, {1, 1}}});
  for (const bool down : {false, true}) {
    chart.y_down = down;
    const std::vector<Pixel> line = drawn_lines(chart_svg(chart)).at(0);
    EXPECT_EQ(line[1].y > line[0].y, down);
  }
}

TEST(ChartSvg, DrawsAPowerLawAsALineWithDecades) {
  Chart chart = of(
      sampled("", 1.0, 1e3, 100, [](double n) { return std::pow(n, -2.0); }));
  chart.x.scale = chart.y.scale = Scale::Logarithmic;

  const std::string svg = chart_svg(chart);

  const std::vector<Pixel> line = drawn_lines(svg).at(0);
  const Pixel a = line.front(), b = line.back();
  for (const Pixel& p : line) {
    const double cross = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    EXPECT_LT(std::abs(cross) / std::hypot(b.x - a.x, b.y - a.y),
              4.0 * kPrinted);
  }
  EXPECT_NE(svg.find(">10<tspan dy=\"-5\" font-size=\"75%\">−6<"),
            std::string::npos);
  EXPECT_GT(count(svg, "stroke-opacity=\"0.05\""), 16u);  // short ticks
}

TEST(ChartSvg, HasNoValueThatALogarithmDoesNotHave) {
  Chart chart = of({"", {{1, 1}, {2, 0}, {3, 10}, {4, -1}, {5, 5}, {6, 6}}});
  chart.y.scale = Scale::Logarithmic;
  chart.y.low = 0.0;

  const std::string svg = chart_svg(chart);

  EXPECT_EQ(drawn_lines(svg).size(), 1u);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(ChartSvg, OfAConstantOrOfNothingHasAFrameAndTicks) {
  for (Chart chart : {of({"", {{0, 5.1}, {1, 5.1 + 1e-14}}}), of({})}) {
    for (const Scale scale : {Scale::Linear, Scale::Logarithmic}) {
      chart.y.scale = scale;
      const std::string svg = chart_svg(chart);
      EXPECT_EQ(xml_flaw(svg), "");
      EXPECT_EQ(svg.find("nan"), std::string::npos);
      EXPECT_GE(count(svg, "text-anchor=\"end\""), 2u);
    }
  }
}

TEST(ChartSvg, HasAKeyBelowThePlotIfThereAreSeveralNames) {
  Chart chart;
  for (int i = 0; i < 7; ++i) {
    chart.curves.push_back({"curve " + std::to_string(i), {{0, 0}, {1, 1}}});
    const std::string svg = chart_svg(chart);
    EXPECT_EQ(count(svg, "class=\"key\""), i == 0 ? 0u : i + 1u);
    const double bottom = drawn_frame(svg).bottom;
    for (const double y : numbers_of(svg, "class=\"key\"", "y")) {
      EXPECT_GT(y, bottom + 42.0);
      EXPECT_LT(y, numbers_of(svg, "<svg", "height").at(0));
    }
    for (const double x : numbers_of(svg, "class=\"key\"", "x")) {
      EXPECT_LT(x, 720.0 - 60.0);
    }
  }
}

TEST(ChartSvg, TellsStrokesApart) {
  std::set<std::string> seen;
  for (const Stroke stroke :
       {Stroke::Solid, Stroke::Dashed, Stroke::Dotted, Stroke::DashDotted}) {
    Chart chart = of({"", {{0, 0}, {1, 1}}});
    chart.curves[0].stroke = stroke;
    seen.insert(chart_svg(chart));
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST(FamilyColours, GetLighterAndStayVisible) {
  EXPECT_TRUE(family_colours(0).empty());
  EXPECT_EQ(family_colours(1).size(), 1u);
  double before = -1.0;
  for (const std::string& colour : family_colours(9)) {
    Colour parts{};
    for (std::size_t c = 0; c < 3; ++c) {
      parts[c] = std::stoi(colour.substr(1 + 2 * c, 2), nullptr, 16);
    }
    const double light = lightness(parts);
    EXPECT_GT(light, before);
    EXPECT_LT(light, 80.0);
    before = light;
  }
}

}  // namespace
}  // namespace brachisto::report
