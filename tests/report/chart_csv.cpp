// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "report/chart.hpp"
#include "report/charts.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::chart_of_everything;
using brachisto::testing::sampled;

struct Row {
  std::string curve;
  double x, y;
};

std::vector<Row> rows(const std::string& csv) {
  std::vector<Row> found;
  std::istringstream in(csv);
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "curve,x,y");
  while (std::getline(in, line)) {
    const std::size_t second = line.rfind(',');
    const std::size_t first = line.rfind(',', second - 1);
    found.push_back({line.substr(0, first),
                     std::stod(line.substr(first + 1, second - first - 1)),
                     std::stod(line.substr(second + 1))});
  }
  return found;
}

TEST(ChartCsv, ReturnsItsNumbers) {
  Chart chart;
  chart.curves = {sampled("y", -1.0, 3.0, 101, [](double x) {
    return 1e-7 * std::exp(std::numbers::pi * x);
  })};

  const std::vector<Row> found = rows(chart_csv(chart));

  // Half a unit of the twelfth digit is at most 5e-12 of the number.
  constexpr double kHalfADigit = 5e-12;
  ASSERT_EQ(found.size(), 101u);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Datum p = chart.curves[0].points[i];
    EXPECT_EQ(found[i].curve, "y");
    EXPECT_NEAR(found[i].x, p.x, kHalfADigit * std::abs(p.x));
    EXPECT_NEAR(found[i].y, p.y, kHalfADigit * std::abs(p.y));
  }
}

TEST(ChartCsv, NamesNoCurveByAFormula) {
  Chart chart;
  for (const char* id : {"-pi/6", "=1+1"}) {
    chart.curves.push_back({.name = "curve", .points = {{-1.0, -2.0}}});
    chart.curves.back().id = id;
  }

  const std::vector<Row> found = rows(chart_csv(chart));

  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].curve, "'-pi/6");
  EXPECT_EQ(found[1].curve, "'=1+1");
  EXPECT_EQ(found[0].x, -1.0);
}

TEST(ChartCsv, HasARowPerPointAlsoWhereACurveIsInterrupted) {
  const std::vector<Row> found = rows(chart_csv(chart_of_everything()));

  EXPECT_EQ(found.size(), 3u + 3u + 4u + 2u + 2u);
  EXPECT_TRUE(std::isnan(found[7].x));
}

TEST(ChartCsv, TellsCurvesOfOneNameApart) {
  Chart chart;
  chart.curves = {{"η_m", {{0, 1}}}, {"η_m", {{0, 2}}}, {"", {{0, 3}}}};
  chart.curves.push_back({"η_m", {{0, 4}}});
  chart.curves.back().id = "own";

  EXPECT_EQ(chart_csv(chart),
            "curve,x,y\nηm,0,1\nηm (2),0,2\ncurve 3,0,3\nown,0,4\n");
}

}  // namespace
}  // namespace brachisto::report
