// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "plot/answer_page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "brachisto/report/result.hpp"
#include "plot/pages.hpp"
#include "plot/tables.hpp"
#include "plot/web_parts.hpp"
#include "report/scale.hpp"
#include "report/solutions.hpp"
#include "report/xml.hpp"

namespace brachisto {
namespace {

using plot::answer_page;
using plot::TrajectoryTable;
using report::Json;
using testing::bead_solution;
using testing::data_of;
using testing::document;
using testing::has;
using testing::Incline;
using testing::kMostBytes;
using testing::limited_solution;
using testing::off_centred_solution;
using testing::xml_flaw;

std::string page_of(const Solution& solution) {
  return answer_page(document(solution), solution.scene,
                     TrajectoryTable::read(report::trajectory_csv(solution)));
}

TEST(AnswerPage, IsWellFormedAndSmall) {
  for (const Solution* solution :
       {&off_centred_solution(), &bead_solution(), &limited_solution(),
        &testing::differentiated_solution(), &testing::uniform_solution()}) {
    const std::string page = page_of(*solution);

    EXPECT_EQ(xml_flaw(page), "");
    EXPECT_LT(page.size(), kMostBytes);
  }
}

TEST(AnswerPage, NeedsNoOtherFile) {
  const std::string page = page_of(limited_solution());

  testing::expect_alone(page);
  EXPECT_TRUE(has(page, plot::kAnswerScript));
  EXPECT_TRUE(has(page, plot::kChartScript));
  EXPECT_TRUE(has(page, plot::kChartLicence));
}

TEST(AnswerPage, HasTheRowsOfTheTable) {
  const Solution& solution = off_centred_solution();
  const auto table = TrajectoryTable::read(report::trajectory_csv(solution));

  const Json rows = data_of(page_of(solution))["rows"];

  for (const auto& [name, values] : rows.items()) {
    ASSERT_EQ(values.size(), table.size()) << name;
    for (std::size_t i = 0; i < table.size(); ++i) {
      // Seven digits.
      const double value = table[name][i];
      EXPECT_NEAR(values[i].get<double>(), value, 5.1e-7 * std::abs(value))
          << name << " of row " << i;
    }
  }
}

TEST(AnswerPage, HasNothingWhereABeadHasNothing) {
  const Json data = data_of(page_of(bead_solution()));

  EXPECT_EQ(data["body"]["rolls"], false);
  EXPECT_TRUE(data["rows"]["kappa_b"][0].is_null());  // −∞
  EXPECT_TRUE(data["rows"]["theta"][1].is_null());
}

TEST(AnswerPage, HasArcsAndSlacksOfLimits) {
  const std::string page = page_of(limited_solution());
  const Json data = data_of(page);

  const LimitOnPath& friction = limited_solution().limits.front();
  ASSERT_EQ(data["arcs"].size(), 3U);
  EXPECT_EQ(data["arcs"][1]["name"], "friction");
  EXPECT_NEAR(data["arcs"][1]["to"].get<double>(), friction.active[1].t.to,
              1e-6);
  EXPECT_EQ(data["bounds"]["friction"], 0.5);
  EXPECT_TRUE(data["rows"].contains("slack_clear_of.half_plane"));
  EXPECT_TRUE(has(page, "What the limits cost"));
}

TEST(AnswerPage, ShowsTextsAsTheyAre) {
  const std::string hostile = "</script><b>&\"']]>\x01";
  Json result = document(limited_solution());
  result["warnings"].push_back(hostile);
  result["infeasible_because"].push_back(hostile);
  result["certificate"]["checks"][0]["name"] = hostile;
  result["certificate"]["checks"][0]["where"] = hostile;
  result["limits"][0]["name"] = hostile;
  result["limits"][0]["active"][0]["t"]["from"] = nullptr;
  result["input"]["scene"]["body"]["shape"] = hostile;
  result["scene"]["body"][hostile] = hostile;
  result["provenance"]["compiler"] = hostile;
  result["search_remark"] = hostile;

  const std::string page = answer_page(
      result, limited_solution().scene,
      TrajectoryTable::read(report::trajectory_csv(limited_solution())));

  EXPECT_EQ(xml_flaw(page), "");
  EXPECT_FALSE(has(page, "<b>&"));
  EXPECT_TRUE(has(page, "&lt;/script&gt;&lt;b&gt;&amp;"));
}

TEST(AnswerPage, IsSmallWhateverTheMesh) {
  const Json result = document(off_centred_solution());
  Incline rough;  // which nothing thins
  rough.normal = [](int row) { return std::sin(1e4 * row * row); };
  rough.radius = 1e-3;
  for (const Incline& incline : {Incline(), rough}) {
    const std::string page = answer_page(
        result, incline.scene(), TrajectoryTable::read(incline.csv(30'000)));

    EXPECT_LT(page.size(), kMostBytes);
    EXPECT_TRUE(has(page, " of the 30000 rows of trajectory.csv"));
  }
}

TEST(AnswerPage, ShowsTheMatrixOfOneElement) {
  SolveOptions options;
  Discretisation& mesh = options.use<Collocation>().discretisation;
  mesh.degree = 3;
  mesh.elements = 30;
  const Scene scene = testing::reference("reference_case").scene();

  const std::string page = page_of(solve(scene, options));

  // x, z, θ, w at four nodes, β at three points and U; three defects of each.
  EXPECT_TRUE(has(page, "the Hessian of its 20 variables"));
  EXPECT_TRUE(has(page, "the Jacobian of its 12 rows"));
  EXPECT_TRUE(has(page, "a chain of 30"));
  EXPECT_FALSE(has(page_of(limited_solution()), "class=\"entries\""));
}

TEST(AnswerPage, TellsTheGripFirst) {
  Solution solution = off_centred_solution();
  auto& grip = solution.diagnostics->least_grip;
  grip[0].mu = INFINITY;
  grip[1].mu = 0.75;
  grip[2].mu = 0.5;
  const std::string page = page_of(solution);
  const std::string head = page.substr(0, page.find("</header>"));

  EXPECT_TRUE(has(head,
                  "<dt>grip, least μ</dt><dd>0.75 from 1 % of the time on, 0.5 "
                  "from 5 % on; more than any at the start itself</dd>"))
      << head;
  EXPECT_TRUE(has(head, "Feasible: the body presses on the track"));
}

TEST(AnswerPage, OfABeadSaysNotThatItPresses) {
  Solution solution = bead_solution();
  solution.diagnostics->min_normal_force = {-3.812e-12, 1.25};

  const std::string page = page_of(solution);

  EXPECT_TRUE(has(page, "Feasible: a bead is held from both sides."));
  EXPECT_FALSE(has(page, "presses on the track all the way"));
  EXPECT_FALSE(has(page, "grip, least μ"));
  EXPECT_TRUE(has(page, "<dd>0 to 2 m g</dd>"));
}

TEST(AnswerPage, OfADesignWithoutGripSaysThatItIsInfeasible) {
  Json result = document(off_centred_solution());
  result["design"]["values"] = nullptr;
  result["design"]["minima"][0]["feasible"] = false;
  const auto page = [&] {
    return answer_page(
        result, off_centred_solution().scene,
        TrajectoryTable::read(report::trajectory_csv(off_centred_solution())));
  };

  EXPECT_TRUE(has(page(), "Infeasible for want of the grip"));
  EXPECT_FALSE(has(page(), "Feasible:"));

  result["design"]["values"]["eta_m"] = 0.5;
  EXPECT_TRUE(has(page(), "Feasible:"));
}

/// What a program reads is there and folded; of checks only those that failed
/// are not.
TEST(AnswerPage, FoldsTheTablesOfKeysUnlessACheckFailed) {
  Json result = document(off_centred_solution());
  const auto page = [&] {
    return answer_page(
        result, off_centred_solution().scene,
        TrajectoryTable::read(report::trajectory_csv(off_centred_solution())));
  };
  const std::string all = page();
  const std::size_t first = all.find("<details");
  EXPECT_GT(all.find("<code>"), first);
  EXPECT_LT(all.rfind("<code>"), all.rfind("</details>"));
  EXPECT_FALSE(has(all.substr(0, first), "<table"));
  EXPECT_FALSE(has(all, "open=\"open\""));

  result["certificate"]["checks"][0]["passed"] = false;

  EXPECT_TRUE(has(page(), "<details open=\"open\"><summary>The certificate"));
}

/// The greatest speed is that of the energy: ½ v² = g·fall for a bead.
TEST(AnswerPage, TellsTheGreatestSpeedByTheLawOfEnergy) {
  const Solution& bead = bead_solution();
  const auto table = TrajectoryTable::read(report::trajectory_csv(bead));
  const double fall = std::ranges::max(table["z_c"]);
  const double speed = std::sqrt(2.0 * bead.scene.gravity * fall);

  EXPECT_TRUE(has(page_of(bead), "<dt>greatest speed of the centre</dt><dd>" +
                                     report::printed(speed, 4) + " m/s"));
}

TEST(AnswerPage, SaysWhatFailed) {
  Json result = document(off_centred_solution());
  result["feasible"] = false;
  result["infeasible_because"] = {"the body would lift off"};

  const std::string page = answer_page(
      result, off_centred_solution().scene,
      TrajectoryTable::read(report::trajectory_csv(off_centred_solution())));

  EXPECT_TRUE(has(page, "Infeasible: the body would lift off."));
}

}  // namespace
}  // namespace brachisto
