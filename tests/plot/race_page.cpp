// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/race_page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/report/result.hpp"
#include "plot/pages.hpp"
#include "plot/tables.hpp"
#include "plot/web_parts.hpp"
#include "report/solutions.hpp"
#include "report/text_table.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using plot::in_order_of_arrival;
using plot::race_page;
using plot::Racer;
using plot::TrajectoryTable;
using report::Json;
using testing::data_of;
using testing::document;
using testing::has;
using testing::Incline;
using testing::kMostBytes;
using testing::xml_flaw;

Racer racer(const std::string& name, const Solution& solution) {
  return {.name = name,
          .result = document(solution),
          .scene = solution.scene,
          .table = TrajectoryTable::read(report::trajectory_csv(solution))};
}

/// A body down an incline, of which no more is known than its time.
Racer on_incline(const std::string& name, const Incline& incline, int rows) {
  return {.name = name,
          .result = {{"transit_time", incline.time}, {"feasible", true}},
          .scene = incline.scene(),
          .table = TrajectoryTable::read(incline.csv(rows))};
}

const std::vector<Racer>& three() {
  static const std::vector<Racer> kRacers =
      in_order_of_arrival({racer("uniform", testing::uniform_solution()),
                           racer("off", testing::off_centred_solution()),
                           racer("bead", testing::bead_solution())});
  return kRacers;
}

TEST(RacePage, IsWellFormedAndNeedsNoOtherFile) {
  const std::string page = race_page(three());

  EXPECT_EQ(xml_flaw(page), "");
  testing::expect_alone(page);
  EXPECT_TRUE(has(page, plot::kMotionScript));
  EXPECT_TRUE(has(page, plot::kRaceScript));
}

TEST(RacePage, HasTheRowsOfAllTablesInTheOrderOfArrival) {
  const Json data = data_of(race_page(three()));

  ASSERT_EQ(data["racers"].size(), 3U);
  double before = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const TrajectoryTable& table = three()[k].table;
    const Json& rows = data["racers"][k]["rows"];
    EXPECT_GE(table.time().back(), before);
    before = table.time().back();
    for (const char* name : {"t", "x_c", "z_c", "beta", "v_c"}) {
      ASSERT_EQ(rows[name].size(), table.size()) << name;
      for (std::size_t i = 0; i < table.size(); ++i) {
        // Seven digits.
        const double value = table[name][i];
        EXPECT_NEAR(rows[name][i].get<double>(), value,
                    5.1e-7 * std::abs(value))
            << name << " of row " << i;
      }
    }
  }
}

TEST(RacePage, ShowsAllBodiesInOneScale) {
  const Json box = data_of(race_page(three()))["box"];

  for (const Racer& one : three()) {
    const double r = one.scene.body.radius;
    for (std::size_t i = 0; i < one.table.size(); ++i) {
      const double x = one.table["x_c"][i], z = one.table["z_c"][i];
      EXPECT_LT(box[0][0].get<double>(), x - r);
      EXPECT_GT(box[1][0].get<double>(), x + r);
      EXPECT_LT(box[0][1].get<double>(), z - r);
      EXPECT_GT(box[1][1].get<double>(), z + r);
    }
  }
}

TEST(RacePage, TellsTheDifferencesInMilliseconds) {
  Incline first, second;
  first.time = 1.5;
  second.time = 1.75;
  const Racer winner = on_incline("winner", first, 9);
  Racer next = on_incline("next", second, 9);

  EXPECT_EQ(behind(winner, winner), "0");
  EXPECT_EQ(behind(winner, next), "+250.000");
  // Of an error of 0.01 s less is known.
  next.result["estimated_error"] = 0.01 / 1.75;
  EXPECT_EQ(behind(winner, next), "+" + report::with_error(250.0, 10.0));
}

TEST(RacePage, KeepsTheOrderOfThoseThatArriveTogether) {
  const Incline incline;

  const std::vector<Racer> racers = in_order_of_arrival(
      {on_incline("b", incline, 9), on_incline("a", incline, 9)});

  EXPECT_EQ(racers[0].name, "b");
  EXPECT_EQ(racers[1].name, "a");
}

TEST(RacePage, OfFiveIsSmallWhateverTheMeshes) {
  std::vector<Racer> racers;
  for (const char* name : {"1", "2", "3", "4", "5"}) {
    racers.push_back(on_incline(name, Incline(), 30'000));
  }

  const std::string page = race_page(racers);

  EXPECT_LT(page.size(), kMostBytes);
  EXPECT_TRUE(has(page, " of the 150000 nodes"));
  EXPECT_TRUE(has(page, "miss none of the others by more than"));
}

TEST(RacePage, HasAnotherStyleForEachOfTheMostThatStart) {
  constexpr int kMost = 24;
  const std::string page =
      race_page(std::vector<Racer>(kMost, on_incline("of many", Incline(), 9)));

  const std::regex row("<tr id=\"racer-[0-9]+\" class=\"(\\w+) (\\w+)\">");
  std::set<std::string> styles;
  for (std::sregex_iterator match(page.begin(), page.end(), row), end;
       match != end; ++match) {
    styles.insert((*match)[1].str() + (*match)[2].str());
    EXPECT_TRUE(has(page, "." + (*match)[1].str() + " {"));
    // The first one has a line without gaps.
    EXPECT_TRUE((*match)[2] == "dash1" ||
                has(page, ".track." + (*match)[2].str() + " {"));
  }
  EXPECT_EQ(styles.size(), kMost);
}

TEST(RacePage, MarksThoseThatCouldNotRun) {
  std::vector<Racer> racers = three();
  racers[1].result["feasible"] = false;
  racers[1].result["infeasible_because"] = {"the body would lift off"};

  const std::string page = race_page(racers);

  EXPECT_TRUE(has(page, "(infeasible)"));
  EXPECT_TRUE(has(page, "Infeasible: the body would lift off"));
  EXPECT_FALSE(has(race_page(three()), "nfeasible"));
}

/// What comes before the list and the list itself leave the guess open.
TEST(RacePage, KeepsTheNumbersOfThoseThatStartAndTellsTheirPlaces) {
  Incline slow, quick;
  slow.time = 2.0;
  quick.time = 1.5;

  const std::string page = race_page(
      {on_incline("slow one", slow, 9), on_incline("quick one", quick, 9)});

  EXPECT_GT(page.find("quick one"), page.find("slow one"));
  EXPECT_GT(page.find("slow one"), page.find("</h1>"));
  const std::regex row(
      "id=\"clock-([0-9])\">([0-9.]+) s</td>"
      "<td class=\"result\">([0-9])</td>");
  std::vector<std::string> told;
  for (std::sregex_iterator match(page.begin(), page.end(), row), end;
       match != end; ++match) {
    told.push_back((*match)[1].str() + " " + (*match)[2].str() + " " +
                   (*match)[3].str());
  }
  EXPECT_EQ(told, (std::vector<std::string>{"0 2.0000 2", "1 1.5000 1"}));
}

TEST(RacePage, OfOneTrackSaysWhose) {
  EXPECT_TRUE(
      has(race_page(three(), true), "on the track of " + three()[0].name));
  EXPECT_FALSE(has(race_page(three()), "on the track of"));
}

TEST(RacePage, ShowsNamesAsTheyAre) {
  const std::string page =
      race_page({racer("</script><b>&\"']]>", testing::bead_solution())});

  EXPECT_EQ(xml_flaw(page), "");
  EXPECT_FALSE(has(page, "<b>&"));
}

}  // namespace
}  // namespace brachisto
