// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <regex>
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
using brachisto::testing::kDegree;
using brachisto::testing::svg_of;
using brachisto::testing::sweep_over;
using brachisto::testing::whole;
using brachisto::testing::xml_flaw;

/// τ = 5 + (η_m − 0.35)² + (θ_m / 180° − 0.25)², η_m from 0 to 0.7, θ_m from
/// −180° to 180°: the minimum is a node of 29 × 33 scenes.
constexpr std::size_t kNx = 29, kNy = 33;
constexpr double kEta = 0.35, kTurn = 0.25;
SweepTable bowl(bool turned = false) {
  const std::size_t eta = turned ? 1 : 0;
  const auto tau = [=](const std::vector<double>& at) {
    const double x = at[eta] - kEta;
    const double y = at[1 - eta] / (180.0 * kDegree) - kTurn;
    return 5.0 + x * x + y * y;
  };
  const testing::Range offset{"scene.body.eta_m", 0.0, 0.7, kNx};
  const testing::Range turn{"scene.body.theta_m", -180 * kDegree, 180 * kDegree,
                            kNy};
  return turned ? sweep_over({turn, offset}, tau)
                : sweep_over({offset, turn}, tau);
}

constexpr Extent kBowlRange{5.0, 7.0};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Cells that are filled with a colour of the palette.
std::size_t cells(const std::string& svg) {
  return count(svg, "<polygon fill = 'rgb(");
}

TEST(MapFigure, HasARowPerSceneAndAnEmptyLineAfterEachRowOfTheGrid) {
  const SweepTable table = bowl();

  const Figure figure = map_figure(table, whole(table), kBowlRange);

  EXPECT_TRUE(
      figure.table.starts_with("θm [°],ηm,tau,state,feasible\n-180,0,"));
  EXPECT_EQ(count(figure.table, "\n"), 1 + kNx * kNy + kNx - 1);
  EXPECT_EQ(count(figure.table, "\n\n"), kNx - 1);
  EXPECT_TRUE(says(figure.table, "\n45,0.35,5,verified,1\n"));
}

TEST(MapFigure, HasOneOrientationWhicheverAxisIsFirst) {
  for (const bool turned : {false, true}) {
    const SweepTable table = bowl(turned);

    const Figure figure = map_figure(table, whole(table), kBowlRange);

    EXPECT_EQ(figure.title, "τ over θm\u00A0and ηm");
    EXPECT_TRUE(says(figure.commands, "set xrange [-180:180]"));
    EXPECT_TRUE(says(figure.commands, "set yrange [0:0.7]"));
  }
}

TEST(MapFigure, FillsAllCellsAndNamesLinesOfEqualTau) {
  const SweepTable table = bowl();

  const std::string svg = svg_of(map_figure(table, whole(table), kBowlRange));

  EXPECT_GE(cells(svg), (kNx - 1) * (kNy - 1));
  for (const char* level : {">5.2</tspan>", ">5.4</tspan>", ">6</tspan>"}) {
    EXPECT_TRUE(says(svg, level)) << level;
  }
}

TEST(MapFigure, MarksTheMinimumOfTheGridWhereItIs) {
  const SweepTable table = bowl();

  const Figure figure = map_figure(table, whole(table), kBowlRange);

  EXPECT_TRUE(says(figure.commands, "$minimum << END\n45,0.35\nEND\n"));
  EXPECT_TRUE(says(svg_of(figure), "minimum of the grid: τ = 5.0000000 at η"));
}

TEST(MapFigure, MarksTheFastestFeasibleSceneAndAFasterInfeasibleOne) {
  SweepTable table = bowl();
  const std::size_t fastest = *digest(table, all_scenes(table)).fastest;
  table.outcomes[fastest].feasible = false;

  const Figure figure = map_figure(table, whole(table), kBowlRange);

  EXPECT_TRUE(says(figure.commands, "$infeasible << END\n45,0.35\nEND\n"));
  EXPECT_TRUE(says(figure.commands, "$minimum << END\n"));
  EXPECT_TRUE(says(figure.commands, "minimum of the grid, feasible: "));
  EXPECT_TRUE(says(figure.commands, "less, but infeasible: "));
}

TEST(MapFigure, OfInfeasibleScenesOnlySaysSoOfTheMinimum) {
  SweepTable table = bowl();
  for (SweepOutcome& outcome : table.outcomes) outcome.feasible = false;

  const Figure figure = map_figure(table, whole(table), kBowlRange);

  EXPECT_FALSE(says(figure.commands, "$minimum"));
  EXPECT_TRUE(says(svg_of(figure), "minimum of the grid, infeasible: "));
}

TEST(MapFigure, DrawsNothingAcrossScenesWithoutAResult) {
  SweepTable table = bowl();
  const std::size_t all =
      cells(svg_of(map_figure(table, whole(table), kBowlRange)));
  for (const std::size_t scene : {100U, 500U}) fail(table, scene);
  table.outcomes[300] = {};

  const Figure figure = map_figure(table, whole(table), kBowlRange);

  const std::string svg = svg_of(figure);
  EXPECT_EQ(count(figure.table, ",nan,failed,nan\n"), 2u);
  EXPECT_EQ(count(figure.table, ",nan,missing,nan\n"), 1u);
  EXPECT_TRUE(says(svg, "no verified result (2)"));
  EXPECT_TRUE(says(svg, "not run yet (1)"));
  // Four cells about each of them are open.
  const std::size_t parts = all / ((kNx - 1) * (kNy - 1));
  EXPECT_EQ(all - cells(svg), 12 * parts);
}

TEST(MapFigure, FollowsAColumnThatDependsOnAnother) {
  // k from 0 to its bound 1 − η_m².
  SweepTable table =
      sweep_over({{"scene.body.eta_m", 0.0, 0.8, 5}, {"scene.body.k", 0, 1, 4}},
                 [](const std::vector<double>& at) { return 5.0 + at[0]; });
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) {
    const double eta = table.columns[0].numbers[i];
    table.columns[1].numbers[i] *= 1.0 - eta * eta;
  }

  const Figure figure = map_figure(table, whole(table), {5.0, 6.0});

  EXPECT_TRUE(says(figure.table, "\n0.8,0.36,5.8,verified,1\n"));
  EXPECT_TRUE(says(figure.commands, "set yrange [0:1]"));
  EXPECT_GT(cells(svg_of(figure)), 0u);
}

TEST(MapFigure, DrawsTheEdgeOfWhatIsInfeasible) {
  SweepTable table = bowl();
  EXPECT_FALSE(
      says(map_figure(table, whole(table), kBowlRange).commands, "infeasible"));
  for (std::size_t scene = 20 * kNy; scene < table.outcomes.size(); ++scene) {
    table.outcomes[scene].feasible = false;
  }

  const std::string svg = svg_of(map_figure(table, whole(table), kBowlRange));

  EXPECT_TRUE(says(svg, "edge of infeasible scenes (297)"));
}

TEST(FeasibilityFigure, NamesItsGreys) {
  SweepTable table = bowl();
  for (std::size_t scene = 20 * kNy; scene < table.outcomes.size(); ++scene) {
    table.outcomes[scene].feasible = false;
  }

  const std::string svg = svg_of(feasibility_figure(table, whole(table)));

  EXPECT_TRUE(says(svg, "feasible (660)"));
  EXPECT_TRUE(says(svg, "could not follow the track (297)"));
  EXPECT_GT(cells(svg), 0u);
}

TEST(MapFigure, OfFailuresOnlyHasCrossesAllOver) {
  SweepTable table = bowl();
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) fail(table, i);

  const std::string svg = svg_of(map_figure(table, whole(table), {0.0, 1.0}));

  EXPECT_TRUE(says(svg, "no verified result (957)"));
  EXPECT_EQ(cells(svg), 0u);
}

TEST(MapFigure, LeavesOutWhatHasNoPlace) {
  SweepTable table = bowl();
  table.columns[0].numbers[0] = std::nan("");

  EXPECT_GT(cells(svg_of(map_figure(table, whole(table), kBowlRange))), 0u);
}

TEST(ScatterFigure, HasADotOfTheColourOfTauForEachScene) {
  SweepTable table = bowl();
  table.axes = {{{0, 1}, kNx * kNy, false}};
  fail(table, 7);
  table.outcomes[8].feasible = false;
  const SweepMap sample{
      .name = "sample", .first = 0, .second = 1, .scenes = all_scenes(table)};

  const Figure figure = scatter_figure(table, sample, kBowlRange);

  const std::string svg = svg_of(figure);
  EXPECT_EQ(count(figure.table, "\n"), 1 + kNx * kNy);
  EXPECT_TRUE(says(svg, "minimum of the sample"));
  EXPECT_TRUE(says(svg, "infeasible (1)"));
  EXPECT_TRUE(says(svg, "no verified result (1)"));
  EXPECT_GE(count(svg, "#gpPt6'"), kNx * kNy - 1);
}

}  // namespace
}  // namespace brachisto::report
