// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// A sweep gives the same table whoever solves it, in whatever portions.

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/pages.hpp"
#include "app/sweep_command.hpp"
#include "plot/pages.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::content;
using testing::kScenes;
using testing::Output;
using testing::Process;
using testing::run;
using testing::ScratchDirectory;
using testing::small_sweep;
using testing::sweep;
using testing::table_of;
using testing::wait_for;

TEST(Sweep, VerifiesEveryScene) {
  const ScratchDirectory scratch;

  const Output output = sweep(scratch, "out", {"--json"});

  EXPECT_EQ(output.code, 0) << output.err;
  const json document = json::parse(output.out);
  EXPECT_EQ(document["scenes"], kScenes);
  EXPECT_EQ(document["verified"], kScenes);
  EXPECT_EQ(document["failed"], 0);
  EXPECT_EQ(document["new"], kScenes);
}

TEST(Sweep, GivesWhatSolveGives) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);
  const auto rows =
      json::parse(
          run({"export", (scratch.path() / "out").string(), "--json"}).out)
          .at("rows");
  for (const json& row : rows) {
    const Output alone = run(
        {"solve", testing::paper_problem("fig04_reference_case"), "--set",
         "discretisation.tolerance=1e-8", "--set",
         "scene.body.eta_m=" + row["scene.body.eta_m"].dump(), "--set",
         "scene.body.theta_m=" + row["scene.body.theta_m"].dump(), "--json"});
    const json result = json::parse(alone.out);
    // The same steps, so the same numbers.
    EXPECT_EQ(row["tau"], result["tau"]) << row["scene"];
  }
}

/// With every scene cold, and with each from the one before.
const std::vector<std::string> kWarmStarts{"sweep.warm_start=false",
                                           "sweep.warm_start=true"};

/// Columns, which other sweeps do not have.
TEST(Sweep, HasTheSlopesOfTauIfTheyAreAskedFor) {
  const ScratchDirectory scratch;
  const auto rows_of = [&](const std::string& name) {
    return json::parse(
               run({"export", (scratch.path() / name).string(), "--json"}).out)
        .at("rows");
  };
  ASSERT_EQ(sweep(scratch, "plain").code, 0);
  ASSERT_EQ(
      sweep(scratch, "slopes", {"--set", "solver.sensitivities=true"}).code, 0);
  const json plain = rows_of("plain"), slopes = rows_of("slopes");

  EXPECT_FALSE(plain[0].contains("sensitivities.k.tau"));
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    EXPECT_EQ(slopes[i]["tau"], plain[i]["tau"]);
    for (const std::string name :
         {"eta_m", "theta_m", "k", "radius", "L", "H"}) {
      EXPECT_TRUE(slopes[i]["sensitivities." + name + ".tau"].is_number())
          << slopes[i];
    }
  }
}

TEST(Sweep, DoesNotDependOnTheNumberOfWorkers) {
  for (const std::string& start : kWarmStarts) {
    const ScratchDirectory scratch;
    for (const std::string jobs : {"1", "2", "5"}) {
      ASSERT_EQ(sweep(scratch, jobs, {"--jobs", jobs, "--set", start}).code, 0);
      EXPECT_EQ(table_of(scratch, "1"), table_of(scratch, jobs)) << start;
    }
  }
}

TEST(Sweep, WarmStartsAgreeWithColdOnesWhereNothingFolds) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "cold", {"--set", kWarmStarts[0]}).code, 0);
  ASSERT_EQ(sweep(scratch, "warm", {"--set", kWarmStarts[1]}).code, 0);
  const auto rows = [&](const char* name) {
    return json::parse(
               run({"export", (scratch.path() / name).string(), "--json"}).out)
        .at("rows");
  };
  const json cold = rows("cold"), warm = rows("warm");
  ASSERT_EQ(cold.size(), warm.size());
  for (std::size_t i = 0; i < cold.size(); ++i) {
    // Two solutions, each within its own estimate of the truth.
    const double tau = cold[i]["tau"];
    EXPECT_NEAR(warm[i]["tau"].get<double>(), tau,
                tau * (cold[i]["estimated_error"].get<double>() +
                       warm[i]["estimated_error"].get<double>()))
        << i;
  }
}

TEST(Sweep, DoesNotDependOnShards) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "whole").code, 0);
  std::vector<std::string> merge{"merge"};
  for (const std::string i : {"1", "2", "3"}) {
    ASSERT_EQ(sweep(scratch, "part" + i, {"--shard", i + "/3"}).code, 0);
    merge.push_back((scratch.path() / ("part" + i)).string());
  }
  merge.insert(merge.end(), {"--out", (scratch.path() / "merged").string()});

  const Output merged = run(merge);

  EXPECT_EQ(merged.code, 0) << merged.err;
  EXPECT_EQ(table_of(scratch, "merged"), table_of(scratch, "whole"));
  EXPECT_EQ(run(merge).code, 0) << "merging again is allowed";
  EXPECT_EQ(table_of(scratch, "merged"), table_of(scratch, "whole"));
  EXPECT_EQ(sweep(scratch, "merged", {"--resume"}).code, 0);
}

TEST(Sweep, StopsSoonAndGoesOnWhereItWas) {
  const ScratchDirectory scratch;
  const std::vector<std::string> warm{"--set", kWarmStarts[1]};
  ASSERT_EQ(sweep(scratch, "calm", warm).code, 0);
  for (const auto& [signal, code] : {std::pair{SIGINT, 130}, {SIGTERM, 143}}) {
    const std::string name = "stopped" + std::to_string(code);
    const std::string out = (scratch.path() / name).string();
    Process process({"sweep", small_sweep(scratch), "--out", out, "--jobs", "1",
                     "--set", kWarmStarts[1]});
    wait_for(scratch.path() / name / "sweep.sqlite");
    process.signal(signal);
    const auto output = process.wait();
    ASSERT_TRUE(output) << "it does not end";
    // On a very fast machine it may have been done already.
    EXPECT_TRUE(output->code == code || output->code == 0) << output->err;

    const Output resumed =
        sweep(scratch, name, {"--resume", "--json", "--set", kWarmStarts[1]});

    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(table_of(scratch, name), table_of(scratch, "calm"));
  }
}

TEST(Sweep, RunsNoFinishedSceneAgain) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);

  const Output again = sweep(scratch, "out", {"--resume", "--json"});

  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_EQ(json::parse(again.out)["new"], 0);
}

/// The tracks on the page of a sweep.
json tracks_of(const ScratchDirectory& scratch, const std::string& name) {
  const std::filesystem::path out = scratch.path() / name;
  EXPECT_EQ(run({"show", out.string(), "--quiet"}).code, 0);
  return testing::data_of(content(out / "report/index.html"))["tracks"];
}

TEST(Sweep, KeepsTheSameTracksWhoeverSolvesIt) {
  const ScratchDirectory scratch;
  const std::vector<std::string> keep{"--set", "sweep.keep=tracks"};
  const auto kept = [&](std::vector<std::string> more) {
    more.insert(more.end(), keep.begin(), keep.end());
    return more;
  };
  ASSERT_EQ(sweep(scratch, "plain").code, 0);
  ASSERT_EQ(sweep(scratch, "one", kept({"--jobs", "1"})).code, 0);
  const json tracks = tracks_of(scratch, "one");

  EXPECT_EQ(tracks.size(), kScenes);
  EXPECT_EQ(table_of(scratch, "one"), table_of(scratch, "plain"));
  EXPECT_TRUE(tracks_of(scratch, "plain").empty());

  ASSERT_EQ(sweep(scratch, "two", kept({"--jobs", "2"})).code, 0);
  EXPECT_EQ(table_of(scratch, "two"), table_of(scratch, "one"));
  EXPECT_EQ(tracks_of(scratch, "two"), tracks);

  Process process({"sweep", small_sweep(scratch), "--out",
                   (scratch.path() / "killed").string(), "--jobs", "2", "--set",
                   "sweep.keep=tracks"});
  wait_for(scratch.path() / "killed" / "sweep.sqlite");
  process.signal(SIGKILL);
  ASSERT_TRUE(process.wait());
  ASSERT_EQ(sweep(scratch, "killed", kept({"--resume"})).code, 0);
  EXPECT_EQ(table_of(scratch, "killed"), table_of(scratch, "one"));
  EXPECT_EQ(tracks_of(scratch, "killed"), tracks);

  std::vector<std::string> merge{"merge"};
  for (const std::string i : {"1", "2"}) {
    ASSERT_EQ(sweep(scratch, "part" + i, kept({"--shard", i + "/2"})).code, 0);
    merge.push_back((scratch.path() / ("part" + i)).string());
  }
  merge.insert(merge.end(), {"--out", (scratch.path() / "merged").string()});
  ASSERT_EQ(run(merge).code, 0);
  EXPECT_EQ(table_of(scratch, "merged"), table_of(scratch, "one"));
  EXPECT_EQ(tracks_of(scratch, "merged"), tracks);
}

TEST(Sweep, IsNotResumedWithOtherThingsKept) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);

  const Output output =
      sweep(scratch, "out", {"--resume", "--set", "sweep.keep=tracks"});

  EXPECT_EQ(output.code, 6);
  EXPECT_NE(output.err.find("sweep.keep differs"), std::string::npos);
}

TEST(Sweep, DrawsAReport) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);
  const std::string out = (scratch.path() / "out").string();

  EXPECT_EQ(run({"report", out}).code, 0);
  EXPECT_TRUE(
      std::filesystem::exists(scratch.path() / "out/report/index.html"));
  EXPECT_EQ(run({"report", out}).code, 6) << "an earlier report is kept";
  EXPECT_EQ(run({"report", out, "--force"}).code, 0);
  EXPECT_EQ(run({"show", out}).code, 0) << "show writes anew";
  EXPECT_EQ(run({"show", out, "--gif"}).code, 6) << "there is no one motion";
}

}  // namespace
}  // namespace brachisto
