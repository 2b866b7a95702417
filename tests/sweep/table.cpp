// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "sweep/table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "support/scratch_directory.hpp"
#include "sweep/small_sweep.hpp"

namespace brachisto::sweep {
namespace {

using testing::answer;
using testing::info_of;
using testing::ScratchDirectory;
using testing::small_job;

class TableTest : public ::testing::Test {
 protected:
  TableTest() {
    const std::string verified =
        R"({"status":"solved","message":"a, \"b\"","verified":true,)"
        R"("feasible":false,"tau":5.09344446659778,"transit_time":1.15,)"
        R"("estimated_error":1e-11,"end_angle":-0.125,"friction":)"
        R"({"share_above_0.3":0.34},"grip":{"least_after":)"
        R"([{"mu":null},{"mu":0.8},{"mu":null}]}})";
    store_.record(std::vector<Answer>{{21, verified, ""}, answer(3)},
                  ChainPlan(job_.file));
  }

  ScratchDirectory scratch_;
  Job job_ = small_job();
  Store store_ = Store::create(scratch_.path(), info_of(job_));
};

TEST_F(TableTest, HasTheValuesOfEverySceneAndWhatCameOut) {
  const SweepTable table = read_table(store_, job_);

  ASSERT_EQ(table.columns.size(), 2U);
  EXPECT_EQ(table.columns[0].key, "scene.body.eta_m");
  ASSERT_EQ(table.outcomes.size(), 40U);
  ASSERT_EQ(table.columns[1].numbers.size(), 40U);
  EXPECT_EQ(table.columns[0].numbers[21], 0.2);
  EXPECT_EQ(table.columns[1].numbers[19], 1.0);
  ASSERT_EQ(table.axes.size(), 2U);
  EXPECT_EQ(table.axes[1].count, 20U);
  EXPECT_EQ(table.outcomes[0].state, SweepOutcome::State::Missing);
  EXPECT_EQ(table.outcomes[3].state, SweepOutcome::State::Failed);
  EXPECT_EQ(table.outcomes[21].state, SweepOutcome::State::Verified);
  EXPECT_EQ(table.outcomes[21].tau, 5.09344446659778);
}

TEST_F(TableTest, NamesWhatAllScenesHaveAlike) {
  const SweepTable table = read_table(store_, job_);

  std::vector<std::string> keys;
  for (const SweepConstant& constant : table.constants) {
    keys.push_back(constant.key);
  }
  EXPECT_EQ(keys,
            (std::vector<std::string>{"scene.body.radius", "scene.body.k",
                                      "scene.finish.L", "scene.finish.H"}));
  EXPECT_EQ(table.constants[1].value, 0.5);
}

TEST_F(TableTest, ExportsNoFormulasAndKeepsSigns) {
  store_.record(
      std::vector<Answer>{
          {5,
           R"({"status":"solved","message":"=cmd|'/c calc'!A1",)"
           R"("verified":false,"end_angle":-0.25})",
           ""}},
      ChainPlan(job_.file));

  const std::string csv = export_csv(store_, job_).text;

  EXPECT_EQ(csv.find(",="), std::string::npos) << csv;
  EXPECT_NE(csv.find(",'=cmd|'/c calc'!A1\n"), std::string::npos) << csv;
  EXPECT_NE(csv.find(",-0.25,"), std::string::npos) << csv;
}

TEST_F(TableTest, ExportsCsv) {
  std::istringstream csv(export_csv(store_, job_).text);
  std::string head, first, second, rest;
  std::getline(csv, head);
  std::getline(csv, first);
  std::getline(csv, second);

  EXPECT_TRUE(head.starts_with(
      "scene,scene.body.eta_m,scene.body.theta_m,status,verified,feasible,tau,"
      "transit_time,estimated_error,"))
      << head;
  EXPECT_TRUE(first.starts_with("3,0.1,")) << first;
  EXPECT_TRUE(second.starts_with("21,0.2,")) << second;
  EXPECT_NE(second.find(",solved,true,false,5.09344446659778,1.15,1e-11,"),
            std::string::npos)
      << second;
  EXPECT_TRUE(second.ends_with("\"a, \"\"b\"\"\"")) << second;
  EXPECT_FALSE(std::getline(csv, rest));
  EXPECT_EQ(std::count(head.begin(), head.end(), ','),
            std::count(first.begin(), first.end(), ','));
}

TEST_F(TableTest, ExportsJson) {
  const auto document = nlohmann::json::parse(export_json(store_, job_).text);

  EXPECT_EQ(document["scenes"], 40);
  EXPECT_EQ(document["finished"], 2);
  ASSERT_EQ(document["rows"].size(), 2U);
  EXPECT_EQ(document["rows"][1]["scene"], 21);
  EXPECT_EQ(document["rows"][1]["tau"], 5.09344446659778);
  EXPECT_EQ(document["rows"][1]["friction.share_above_0.3"], 0.34);
  EXPECT_EQ(document["rows"][1]["grip.mu_after_1_percent"], 0.8);
  EXPECT_TRUE(document["rows"][1]["grip.mu_after_5_percent"].is_null());
  EXPECT_TRUE(document["rows"][0]["tau"].is_null());
}

}  // namespace
}  // namespace brachisto::sweep
