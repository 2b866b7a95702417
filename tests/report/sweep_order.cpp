// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/sweep_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "report/sweep_pictures.hpp"
#include "report/sweep_tables.hpp"

namespace brachisto::report {
namespace {

using brachisto::testing::list_over;
using brachisto::testing::sweep_over;
using brachisto::testing::whole;
using ::testing::ElementsAre;

double sum(const std::vector<double>& at) {
  return 5.0 + at[0] + at[1];
}

SweepTable lists(const std::vector<double>& k, const std::vector<double>& l) {
  return list_over({{"scene.body.k", k}, {"scene.finish.L", l}}, sum);
}

TEST(SortedBy, PutsScenesInTheOrderOfTheirNumbers) {
  SweepColumn column{"k", {0.5, std::nan(""), 0.1, 0.5, 0.3}, {}};
  EXPECT_THAT(sorted_by(column, {0, 1, 2, 3, 4}), ElementsAre(2, 4, 0, 3, 1));

  column = {"shape", {}, {"b", "a"}};
  EXPECT_THAT(sorted_by(column, {0, 1}), ElementsAre(0, 1));
}

TEST(Distinct, IsWhatHasNoValueTwice) {
  const SweepColumn numbers{"k", {0.5, 0.1, 0.5}, {}};
  EXPECT_TRUE(distinct(numbers, {0, 1}));
  EXPECT_FALSE(distinct(numbers, {0, 1, 2}));

  const SweepColumn words{"shape", {}, {"b", "a", "b"}};
  EXPECT_TRUE(distinct(words, {0, 1}));
  EXPECT_FALSE(distinct(words, {0, 1, 2}));
}

TEST(MapOrder, OfWhatIsInOrderKeepsIt) {
  for (const SweepTable& table :
       {lists({0.1, 0.2, 0.3}, {1.0, 10.0}), lists({0.3, 0.2, 0.1}, {1, 2})}) {
    EXPECT_EQ(in_map_order(table, whole(table)), all_scenes(table));
  }
}

TEST(MapOrder, OfListsIsThatOfTheirValues) {
  const SweepTable table = lists({0.1, 0.5, 0.3}, {10.0, 1.0, 100.0});

  const auto order = in_map_order(table, whole(table));

  ASSERT_TRUE(order);
  EXPECT_THAT(*order, ElementsAre(1, 0, 2, 7, 6, 8, 4, 3, 5));
}

TEST(MapOrder, OfValuesThatAreThereTwiceIsNone) {
  for (const SweepTable& table :
       {lists({0.3, 0.3, 0.3}, {1.0, 2.0}), lists({0.1, 0.3, 0.1}, {1.0, 2.0}),
        lists({0.1, 0.2}, {2.0, 1.0, 2.0})}) {
    EXPECT_FALSE(in_map_order(table, whole(table)));
  }
}

/// η_m and a share of the bound of k, mixed up; k itself follows.
SweepTable bent(const std::vector<double>& eta,
                const std::vector<double>& share) {
  SweepTable table =
      list_over({{"scene.body.eta_m", eta}, {"scene.body.k", share}}, sum);
  for (std::size_t i = 0; i < table.outcomes.size(); ++i) {
    const double x = table.columns[0].numbers[i];
    table.columns[1].numbers[i] *= 1.0 - x * x;
  }
  return table;
}

TEST(MapOrder, OfABentGridFollowsItEvenToAPoint) {
  const SweepTable table = bent({1.0, 0.0, 0.5}, {0.2, 1.0, 0.6});

  const auto order = in_map_order(table, whole(table));

  ASSERT_TRUE(order);
  EXPECT_THAT(*order, ElementsAre(3, 5, 4, 6, 8, 7, 0, 2, 1));
}

TEST(MapOrder, OfAGridThatOverlapsIsNone) {
  // The lines of equal share cross between the values of η_m.
  SweepTable table = lists({0.1, 0.2, 0.3}, {1.0, 2.0});
  table.columns[1].numbers = {1.0, 2.0, 2.0, 1.0, 1.0, 2.0};

  EXPECT_FALSE(in_map_order(table, whole(table)));
}

TEST(MapOrder, DoesNotMindWhatHasNoPlace) {
  SweepTable table = lists({0.1, 0.5, 0.3}, {1.0, 2.0, 3.0});
  table.columns[0].numbers[4] = std::nan("");

  EXPECT_THAT(in_map_order(table, whole(table)).value_or(Scenes{}),
              ElementsAre(0, 1, 2, 6, 7, 8, 3, 4, 5));
}

}  // namespace
}  // namespace brachisto::report
