// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/heat_map_svg.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <regex>
#include <string>
#include <vector>

#include "report/sweep_tables.hpp"
#include "report/xml.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::count;
using brachisto::testing::fail;
using brachisto::testing::kDegree;
using brachisto::testing::sweep_over;
using brachisto::testing::xml_flaw;

constexpr double kPixel = 0.06;  // that coordinates are rounded to, and some

struct Place {
  double x, y;
};

struct Box {
  double left, top, width, height;
};

/// All coordinate pairs of a text.
std::vector<Place> places(const std::string& text) {
  static const std::regex kPair(R"((-?[0-9.]+),(-?[0-9.]+))");
  std::vector<Place> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kPair), end; at != end;
       ++at) {
    found.push_back({std::stod((*at)[1]), std::stod((*at)[2])});
  }
  return found;
}

/// Attribute of each element of a class.
std::vector<std::string> attributes(const std::string& svg,
                                    const std::string& of_class,
                                    const std::string& attribute) {
  const std::regex element("<[a-z]+ [^>]*class=\"" + of_class + "\"[^>]*>");
  const std::regex value(" " + attribute + "=\"([^\"]*)\"");
  std::vector<std::string> found;
  for (std::sregex_iterator at(svg.begin(), svg.end(), element), end; at != end;
       ++at) {
    const std::string tag = at->str();
    std::smatch match;
    if (std::regex_search(tag, match, value)) found.push_back(match[1]);
  }
  return found;
}

/// The rectangle around the plot, the first that is not filled.
Box frame(const std::string& svg) {
  static const std::regex kFrame(
      R"rx(<rect x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)" height="([0-9.]+)" fill="none")rx");
  std::smatch match;
  if (!std::regex_search(svg, match, kFrame)) return {0, 0, 0, 0};
  return {std::stod(match[1]), std::stod(match[2]), std::stod(match[3]),
          std::stod(match[4])};
}

/// τ = 5 + (η_m − 0.35)² + (θ_m / 180° − 0.25)², η_m from 0 to 0.7, θ_m from
/// −180° to 180°: the minimum is a node of 29 × 33 scenes.
constexpr std::size_t kNx = 29, kNy = 33;
constexpr double kEta = 0.35, kTurn = 0.25;
SweepTable bowl() {
  return sweep_over(
      {{"scene.body.eta_m", 0.0, 0.7, kNx},
       {"scene.body.theta_m", -180 * kDegree, 180 * kDegree, kNy}},
      [](const std::vector<double>& at) {
        const double x = at[0] - kEta;
        const double y = at[1] / (180.0 * kDegree) - kTurn;
        return 5.0 + x * x + y * y;
      });
}

SweepMap whole(const SweepTable& table) {
  return {0,     1, table.axes[0].count, table.axes[1].count, all_scenes(table),
          "map", {}};
}

constexpr ValueRange kRange{5.0, 7.0};

TEST(HeatMap, IsWellFormed) {
  SweepTable table = bowl();
  fail(table, 40);
  table.outcomes[41] = {};
  table.outcomes[42].feasible = false;

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(xml_flaw(feasibility_map_svg(table, whole(table))), "");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf,"), std::string::npos);
}

TEST(HeatMap, MarksTheMinimumWhereItIs) {
  const SweepTable table = bowl();

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  const Box box = frame(svg);
  const auto cx = attributes(svg, "minimum", "cx");
  const auto cy = attributes(svg, "minimum", "cy");
  ASSERT_EQ(cx.size(), 1u);
  EXPECT_NEAR(std::stod(cx[0]), box.left + kEta / 0.7 * box.width, kPixel);
  EXPECT_NEAR(std::stod(cy[0]),
              box.top + (1.0 - 0.5 * (kTurn + 1.0)) * box.height, kPixel);
  EXPECT_NE(svg.find("= 5 at"), std::string::npos);
  EXPECT_NE(svg.find("45°"), std::string::npos);
}

TEST(HeatMap, MarksTheFastestFeasibleSceneAndAFasterInfeasibleOne) {
  SweepTable table = bowl();
  const std::size_t fastest = *digest(table, all_scenes(table)).fastest;
  table.outcomes[fastest].feasible = false;

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  const auto open = attributes(svg, "infeasible-minimum", "cx");
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NEAR(std::stod(open[0]),
              frame(svg).left + kEta / 0.7 * frame(svg).width, kPixel);
  EXPECT_EQ(attributes(svg, "infeasible-minimum", "fill"),
            std::vector<std::string>{"none"});
  EXPECT_EQ(attributes(svg, "minimum", "fill"),
            std::vector<std::string>{"#000000"});
  EXPECT_NE(svg.find("minimum, feasible: "), std::string::npos);
  EXPECT_NE(svg.find("faster, but infeasible: "), std::string::npos);
}

TEST(HeatMap, OfInfeasibleScenesOnlySaysSoOfTheMinimum) {
  SweepTable table = bowl();
  for (SweepOutcome& outcome : table.outcomes) outcome.feasible = false;

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  EXPECT_EQ(count(svg, "class=\"infeasible-minimum\""), 1u);
  EXPECT_EQ(count(svg, "class=\"minimum\""), 0u);
  EXPECT_NE(svg.find("minimum, infeasible: "), std::string::npos);
}

TEST(HeatMap, ClipsContoursToItsFrame) {
  const SweepTable table = bowl();

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  const std::size_t clip = svg.find("<g clip-path=\"url(#map-frame)\">");
  ASSERT_NE(clip, std::string::npos);
  EXPECT_NE(svg.find("<clipPath id=\"map-frame\"><rect x=\"80.0\" "),
            std::string::npos);
  EXPECT_LT(clip, svg.find("class=\"contour\""));
  EXPECT_GT(svg.find("</g>"), svg.rfind("class=\"contour\""));
}

TEST(HeatMap, BreaksAHeadingThatIsTooLong) {
  SweepTable table = bowl();
  SweepMap map = whole(table);
  for (int i = 0; i < 6; ++i) {
    map.fixed.push_back(table.columns.size());
    table.columns.push_back({"solver.limits.number_" + std::to_string(i),
                             std::vector<double>(kNx * kNy, 0.125),
                             {}});
  }

  const std::string svg = heat_map_svg(table, map, kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, ">solver.limits.number_2 = 0.125,<"), 1u);
  // What is above the plot needs more room.
  static const std::regex kTop("viewBox=\"0 (-[0-9]+) ");
  static const std::regex kFirst(
      "y=\"(-[0-9.]+)\"[^>]*>solver.limits.number_0");
  std::smatch top, first;
  ASSERT_TRUE(std::regex_search(svg, top, kTop));
  ASSERT_TRUE(std::regex_search(svg, first, kFirst));
  EXPECT_LT(std::stod(top[1]), std::stod(first[1]) - 14.0);
}

TEST(HeatMap, HasContoursWhereTheFunctionHasThem) {
  const SweepTable table = bowl();

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  const Box box = frame(svg);
  const auto lines = attributes(svg, "contour", "points");
  ASSERT_GE(lines.size(), 5u);
  for (const std::string& line : lines) {
    std::vector<double> tau;
    for (const Place& p : places(line)) {
      const double x = 0.7 * (p.x - box.left) / box.width - kEta;
      const double y = 1.0 - 2.0 * (p.y - box.top) / box.height - kTurn;
      tau.push_back(5.0 + x * x + y * y);
    }
    // Levels are 0.2 apart; within a cell linear interpolation is out by a
    // quarter of the square of its sides, 0.025 and 1/16, at most.
    for (const double value : tau) {
      EXPECT_NEAR(value, 0.2 * std::round(value / 0.2), 0.0012);
      EXPECT_NEAR(value, tau.front(), 0.0024);
    }
  }
}

TEST(HeatMap, HatchesEachFailedSceneAndOpensEachMissingOne) {
  SweepTable table = bowl();
  for (const std::size_t scene : {0, 77, 78, 79, 500, 956}) fail(table, scene);
  for (const std::size_t scene : {3, 4, 400}) table.outcomes[scene] = {};

  for (const std::string& svg : {heat_map_svg(table, whole(table), kRange),
                                 feasibility_map_svg(table, whole(table))}) {
    EXPECT_EQ(count(svg, "class=\"failed\""), 6u);
    EXPECT_EQ(count(svg, "class=\"missing\""), 3u);
    EXPECT_NE(svg.find("no verified result (6)"), std::string::npos);
    EXPECT_NE(svg.find("not run yet (3)"), std::string::npos);
  }
}

TEST(HeatMap, HasNoContourThroughAFailedCell) {
  SweepTable table = bowl();
  for (std::size_t scene = 0; scene < table.outcomes.size(); scene += 7) {
    fail(table, scene);
  }

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  std::size_t checked = 0;
  for (const std::string& cell : attributes(svg, "failed", "d")) {
    const std::vector<Place> corners = places(cell);
    ASSERT_EQ(corners.size(), 4u);
    const auto [left, right] = std::minmax({corners[0].x, corners[2].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[2].y});
    for (const std::string& line : attributes(svg, "contour", "points")) {
      for (const Place& p : places(line)) {
        ++checked;
        EXPECT_FALSE(p.x > left + kPixel && p.x < right - kPixel &&
                     p.y > top + kPixel && p.y < bottom - kPixel)
            << p.x << ", " << p.y;
      }
    }
  }
  EXPECT_GT(checked, 1000u);
}

TEST(HeatMap, FollowsAColumnThatDependsOnAnother) {
  // k from 0 to its bound 1 − η_m²: the cell of the last scene ends there.
  SweepTable table =
      sweep_over({{"scene.body.eta_m", 0.0, 0.8, 5}, {"scene.body.k", 0, 1, 4}},
                 [](const std::vector<double>& at) { return 5.0 + at[0]; });
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) {
    const double eta = table.columns[0].numbers[i];
    table.columns[1].numbers[i] *= 1.0 - eta * eta;
  }
  fail(table, 19);

  const std::string svg = heat_map_svg(table, whole(table), {5.0, 6.0});

  const Box box = frame(svg);
  const auto cell = places(attributes(svg, "failed", "d").at(0));
  const double top = box.top + box.height * (1.0 - (1.0 - 0.8 * 0.8));
  EXPECT_NEAR(cell.at(2).x, box.left + box.width, kPixel);
  EXPECT_NEAR(cell.at(2).y, top, kPixel);
}

TEST(HeatMap, DrawsTheEdgeOfWhatIsInfeasible) {
  SweepTable table = bowl();
  EXPECT_EQ(heat_map_svg(table, whole(table), kRange).find("infeasible"),
            std::string::npos);
  for (std::size_t scene = 20 * kNy; scene < table.outcomes.size(); ++scene) {
    table.outcomes[scene].feasible = false;
  }

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  EXPECT_NE(svg.find("edge of infeasible scenes (297)"), std::string::npos);
  // One piece of edge per value of θ_m, all at the middle between two η_m.
  const Box box = frame(svg);
  const std::string x = fmt::format(
      "{:.1f},", box.left + box.width * 19.5 / static_cast<double>(kNx - 1));
  static const std::regex kEdge(
      R"rx(d="([^"]*)" fill="none" stroke="#000000")rx");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(svg, match, kEdge));
  EXPECT_EQ(count(match[1], "M" + x), kNy);
  EXPECT_EQ(count(match[1], "L" + x), kNy);
}

TEST(HeatMap, OfFailuresOnlyIsHatchedAllOver) {
  SweepTable table = bowl();
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) fail(table, i);

  const std::string svg = heat_map_svg(table, whole(table), {0.0, 1.0});

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(count(svg, "class=\"failed\""), kNx * kNy);
  EXPECT_EQ(count(svg, "class=\"contour\""), 0u);
  EXPECT_EQ(count(svg, "class=\"minimum\""), 0u);
}

TEST(HeatMap, LeavesOutWhatHasNoPlace) {
  SweepTable table = bowl();
  table.columns[0].numbers[0] = std::nan("");

  const std::string svg = heat_map_svg(table, whole(table), kRange);

  EXPECT_EQ(xml_flaw(svg), "");
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace brachisto::report
