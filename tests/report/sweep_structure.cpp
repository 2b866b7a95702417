// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "report/sweep_plots.hpp"
#include "report/sweep_tables.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::count;
using brachisto::testing::fail;
using brachisto::testing::sweep_over;

/// μ from 0 to 1 in eleven scenes. Friction holds from A for a share of 0.1 +
/// 0.1 (1 − μ), below 0.45 also about 0.5, below 0.75 from 0.9 to B, above that
/// from 0.9 to 0.95.
SweepTable with_arcs() {
  SweepTable table =
      sweep_over({{"scene.limits.friction", 0.0, 1.0, 11}},
                 [](const std::vector<double>& at) { return 5.0 - at[0]; });
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) {
    const double mu = table.columns[0].numbers[i];
    std::vector<SweepArc>& arcs = table.outcomes[i].arcs;
    arcs.push_back({"friction", 0.0, 0.1 + 0.1 * (1.0 - mu)});
    if (mu < 0.45) arcs.push_back({"friction", 0.3 + mu / 2, 0.7 - mu / 2});
    arcs.push_back({"friction", 0.9, mu < 0.75 ? 1.0 : 0.95});
  }
  return table;
}

SweepDrawing structure(const SweepTable& table) {
  XyPlot plot;
  plot.name = "curve";
  plot.curves = {all_scenes(table)};
  return structure_drawing(table, plot, 0).value_or(SweepDrawing{});
}

TEST(SweepStructure, IsDrawnWhereLimitsHold) {
  SweepTable table = with_arcs();
  const SweepFigures figures = sweep_figures(table);
  ASSERT_EQ(figures.figures.size(), 1U);
  ASSERT_EQ(figures.figures[0].drawings.size(), 2U);
  EXPECT_EQ(figures.figures[0].drawings[1].figure.name, "curve-1-limits");

  for (SweepOutcome& outcome : table.outcomes) outcome.arcs.clear();
  EXPECT_EQ(sweep_figures(table).figures[0].drawings.size(), 1U);
}

TEST(SweepStructure, NamesWhereArcsEndAndBetweenWhichValues) {
  const auto [figure, caption] = structure(with_arcs());

  EXPECT_NE(caption.find("at 0.4 … 0.5, friction at 0.50 ends; 0.7 … 0.8, "
                         "friction leaves B."),
            std::string::npos)
      << caption;
  EXPECT_EQ(count(caption, "…"), 2U) << "no other kinks";
  EXPECT_EQ(count(figure.commands, "between scenes with other arcs"), 1U)
      << "one entry of the key for one meaning";
}

TEST(SweepStructure, BandsEndHalfWayToOtherArcs) {
  const Figure figure = structure(with_arcs()).figure;

  // The middle arc of μ = 0.4, from 0.5 to 0.5 there, up to μ = 0.45.
  EXPECT_NE(figure.table.find(",0.45,0.5\n"), std::string::npos)
      << figure.table;
  EXPECT_EQ(figure.table.find(",0.5,0.5\n"), std::string::npos);
}

TEST(SweepStructure, HasNoBandsAcrossScenesThatFailed) {
  SweepTable table = with_arcs();
  fail(table, 2);
  const auto [figure, caption] = structure(table);

  EXPECT_NE(figure.commands.find("no verified result (1)"), std::string::npos);
  EXPECT_EQ(figure.table.find(",0.2,0.18"), std::string::npos)
      << "between 0.1 and 0.3 nothing is known of the arc at A";
  EXPECT_EQ(count(caption, "…"), 2U) << "what failed is no kink";
}

}  // namespace
}  // namespace brachisto::report
