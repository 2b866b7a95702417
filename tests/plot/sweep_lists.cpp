// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "plot/sweep_files.hpp"
#include "report/sweep_tables.hpp"

namespace brachisto {
namespace {

using report::OutputFile;
using testing::count;
using ::testing::ElementsAre;
using testing::list_over;
using testing::names;
using testing::sum;
using testing::sweep_report;

TEST(SweepOfLists, DrawsTheMapOfItsValuesInOrder) {
  const auto map = [](const std::vector<double>& k) {
    const auto files = sweep_report(list_over(
        {{"scene.body.k", k}, {"scene.finish.L", {1.0, 10.0, 100.0}}}, sum));
    EXPECT_EQ(files[2].name, "map-1.svg");
    return files[2].content;
  };

  EXPECT_EQ(map({0.1, 0.5, 0.3}), map({0.1, 0.3, 0.5}));
}

TEST(SweepOfLists, HasNoMapButCurvesOrDotsOfValuesTwice) {
  const auto drawn = [](const std::vector<double>& k,
                        const std::vector<double>& length) {
    const SweepTable table =
        list_over({{"scene.body.k", k}, {"scene.finish.L", length}}, sum);
    return names(sweep_report(table));
  };

  for (const std::vector<double>& k :
       {std::vector{0.3, 0.3, 0.3}, std::vector{0.1, 0.3, 0.1}}) {
    EXPECT_THAT(drawn(k, {1.0, 2.0, 3.0, 4.0}), ElementsAre("map-1-curves"));
    EXPECT_THAT(drawn({1.0, 2.0, 3.0, 4.0}, k), ElementsAre("map-1-curves"));
    EXPECT_THAT(drawn(k, {2.0, 1.0, 2.0}), ElementsAre("map-1-1", "map-1-2"));
  }
}

TEST(SweepOfLists, JoinsACurveInTheOrderOfItsValues) {
  const auto curve = [](const std::vector<double>& k) {
    return sweep_report(list_over({{"scene.body.k", k}}, sum))[1].content;
  };

  EXPECT_EQ(curve({0.1, 0.5, 0.3}), curve({0.1, 0.3, 0.5}));
  EXPECT_EQ(count(curve({0.1, 0.3, 0.5}), "with linespoints"), 1u);
  EXPECT_EQ(count(curve({0.1, 0.5, 0.1}), "with linespoints"), 0u);
}

TEST(SweepOfLists, DrawsAnAxisByTheKeyThatTellsItsValuesApart) {
  SweepTable table = list_over({{"scene.finish.H", {1.0, 1.0, 1.0}}}, sum);
  table.columns.push_back({"scene.body.k", {0.1, 0.2, 0.3}, {}});
  table.axes[0].columns = {0, 1};

  const std::string page = sweep_report(table).back().content;
  EXPECT_EQ(count(page, "<i>τ</i> against <i>k</i>."), 1u);
}

}  // namespace
}  // namespace brachisto
