// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A sweep whose scenes are solved side by side has the answers of their own
// solves, and the same table whoever solves it.

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/command.hpp"
#include "app/sweep_command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Process;
using testing::run;
using testing::ScratchDirectory;
using testing::small_sweep;
using testing::sweep;
using testing::table_of;
using testing::wait_for;

json rows_of(const ScratchDirectory& scratch, const std::string& name) {
  return json::parse(
             run({"export", (scratch.path() / name).string(), "--json"}).out)
      .at("rows");
}

class SweepInLanesOf : public ::testing::TestWithParam<const char*> {};

TEST_P(SweepInLanesOf, HasTheAnswersOfTheScenesOwnSolves) {
  const ScratchDirectory scratch;
  const std::vector<std::string> asked{"--set", "solver.sensitivities=true",
                                       "--set", GetParam()};
  std::vector<std::string> in_lanes = asked;
  in_lanes.insert(in_lanes.end(), {"--set", "solver.method=auto"});
  ASSERT_EQ(sweep(scratch, "own", asked).code, 0);
  ASSERT_EQ(sweep(scratch, "lanes", in_lanes).code, 0);
  const json own = rows_of(scratch, "own"), lanes = rows_of(scratch, "lanes");

  ASSERT_EQ(lanes.size(), own.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const json &a = own[i], &b = lanes[i];
    EXPECT_FALSE(a.contains("engine"));
    EXPECT_EQ(b["engine"], "lanes") << i;
    EXPECT_TRUE(b["nodes"].is_null() && b["iterations"].is_null()) << i;
    EXPECT_EQ(b["verified"], a["verified"]) << i;
    EXPECT_EQ(b["feasible"], a["feasible"]) << i;
    const double tau = a["tau"];
    EXPECT_NEAR(
        b["tau"].get<double>() / tau, 1.0,
        a["estimated_error"].get<double>() + b["estimated_error"].get<double>())
        << i;
    // On the mesh of a solve to 1e-8 forces and angles have fewer digits.
    for (const char* figure :
         {"end_angle", "normal_force.max", "fold_margin", "curvature.max",
          "friction.share_above_0.5", "grip.mu_after_5_percent",
          "sensitivities.eta_m.tau", "sensitivities.L.tau"}) {
      EXPECT_NEAR(b[figure].get<double>(), a[figure].get<double>(), 2e-4)
          << figure << " " << i;
    }
  }
}

std::string world_of(const ::testing::TestParamInfo<const char*>& one) {
  constexpr std::array kNames{"Free", "InAir", "Pushed"};
  return kNames.at(one.index);
}
INSTANTIATE_TEST_SUITE_P(Worlds, SweepInLanesOf,
                         ::testing::Values("scene.air.linear=0",
                                           "scene.air.linear=0.2",
                                           "scene.start.speed=1"),
                         world_of);

class MixedSweep
    : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(MixedSweep, IsTheSameWhoeverSolvesIt) {
  const std::vector<std::string> mixed{"--set", "solver.method=auto",
                                       "--set", GetParam().first,
                                       "--set", GetParam().second};
  for (const char* warm : {"sweep.warm_start=false", "sweep.warm_start=true"}) {
    const ScratchDirectory scratch;
    const auto with = [&](std::vector<std::string> more) {
      more.insert(more.end(), mixed.begin(), mixed.end());
      more.insert(more.end(), {"--set", warm});
      return more;
    };
    ASSERT_EQ(sweep(scratch, "one", with({"--jobs", "1"})).code, 0);
    std::set<std::string> engines;
    for (const json& row : rows_of(scratch, "one")) {
      engines.insert(row["engine"]);
    }
    EXPECT_EQ(engines, (std::set<std::string>{"lanes", "own"}));

    ASSERT_EQ(sweep(scratch, "two", with({"--jobs", "2"})).code, 0);
    EXPECT_EQ(table_of(scratch, "two"), table_of(scratch, "one"));

    std::vector<std::string> killed{"sweep", small_sweep(scratch), "--out",
                                    (scratch.path() / "killed").string()};
    for (const std::string& word : with({"--jobs", "2"})) {
      killed.push_back(word);
    }
    Process process(killed);
    wait_for(scratch.path() / "killed" / "sweep.sqlite");
    process.signal(SIGKILL);
    ASSERT_TRUE(process.wait());
    ASSERT_EQ(sweep(scratch, "killed", with({"--resume"})).code, 0);
    EXPECT_EQ(table_of(scratch, "killed"), table_of(scratch, "one"));

    std::vector<std::string> merge{"merge"};
    for (const std::string i : {"1", "2"}) {
      ASSERT_EQ(sweep(scratch, "part" + i, with({"--shard", i + "/2"})).code,
                0);
      merge.push_back((scratch.path() / ("part" + i)).string());
    }
    merge.insert(merge.end(), {"--out", (scratch.path() / "merged").string()});
    ASSERT_EQ(run(merge).code, 0);
    EXPECT_EQ(table_of(scratch, "merged"), table_of(scratch, "one"));
  }
}

/// So accurate, and so far, that some scenes are left to their own solves, and
/// with a floor that some paths touch.
INSTANTIATE_TEST_SUITE_P(
    Of, MixedSweep,
    ::testing::Values(
        std::pair("discretisation.tolerance=1e-13", "scene.finish.L=5"),
        std::pair("scene.finish.L=3", "scene.limits.floor=1.35")));

}  // namespace
}  // namespace brachisto
