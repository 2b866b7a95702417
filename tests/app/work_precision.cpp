// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto compare and work-precision: every method in a process of its own.
// Nothing here depends on how fast the machine is.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;

std::string scene(const std::string& name) {
  return std::string(BRACHISTO_PROBLEMS_DIR) + "/work_precision/" + name +
         ".yaml";
}

/// The entry of a list whose key has that value; null if there is none.
json find(const json& list, const char* key, const std::string& value) {
  for (const json& entry : list) {
    if (entry.at(key) == value) return entry;
  }
  return nullptr;
}

TEST(Measure, PrintsOneLineWithTimesAndTheResult) {
  const Output output = run({"measure", scene("bead"), "--repetitions", "2"});

  ASSERT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(output.out.find('\n'), output.out.size() - 1);
  const json line = json::parse(output.out);
  EXPECT_EQ(line["cpu"].size(), 2U);
  EXPECT_EQ(line["tau"], line["result"]["tau"]);
  EXPECT_EQ(line["unknowns"], line["result"]["variables"]);
  EXPECT_GT(line["result"]["seconds"]["cpu"], 0.0);
}

TEST(Measure, IsNotInTheHelp) {
  EXPECT_EQ(run({"--help"}).out.find("measure "), std::string::npos);
}

TEST(Compare, PutsAllMethodsBesideEachOther) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();

  const Output output =
      run({"compare", scene("uniform"), "--nodes", "31", "--repetitions", "1",
           "--json", "--quiet", "--out", out});

  ASSERT_EQ(output.code, 0) << output.err;
  const json document = json::parse(output.out);
  // The closed form, to the digits that are known of it.
  EXPECT_NEAR(document["reference"]["tau"], 5.115100653580, 5e-13);
  const json& rows = document["methods"];
  const json collocation = find(rows, "method", "rolling_time");
  EXPECT_EQ(collocation["verdict"], "verified");
  // The default tolerance, and the digits of the reference.
  EXPECT_LT(collocation["error"], 1e-10 + 1e-12);
  for (const std::string arm : {"rest", "release", "newton", "lifted"}) {
    const json row = find(rows, "method", "fsolve " + arm);
    ASSERT_FALSE(row.is_null()) << arm;
    // First order at best: solved, but nothing to rely on.
    EXPECT_NE(row["verdict"], "verified") << arm;
    EXPECT_TRUE(row["outcome"] == "solved" || !row["cause"].is_null()) << arm;
  }
  for (const char* name : {"index.html", "compare.txt", "compare.json",
                           "compare.svg", "compare.csv", "compare.gp"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  }
  const std::string sentence = document["finding"]["sentence"];
  EXPECT_TRUE(sentence.starts_with("To an error of 1e−6 the program needs "))
      << sentence;
}

TEST(Compare, UnderLimitsTellsWhatOthersDoAndWhyTheyRefuse) {
  const Output output = run({"compare", scene("friction"), "--nodes", "51",
                             "--repetitions", "1", "--json", "--quiet"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json document = json::parse(output.out);
  EXPECT_EQ(document["reference"]["method"], "extremal");
  EXPECT_TRUE(document["reference"]["instead_of"].is_null());
  // By the indirect method outside this project (docs/validation.md), to half
  // a unit of its last digit.
  EXPECT_NEAR(document["reference"]["tau"], 5.083389161786, 1e-12);
  const json refused = find(document["methods"], "method", "fsolve rest");
  EXPECT_EQ(refused["outcome"], "refused");
  EXPECT_TRUE(refused["cause"].get<std::string>().starts_with(
      "fsolve is not allowed with scene.limits"))
      << refused["cause"];
}

TEST(Compare, AGivenPathLeavesNothingToCompare) {
  const Output output =
      run({"compare", testing::paper_problem("fig04_parabola"), "--json"});

  EXPECT_EQ(output.code, 3);
  EXPECT_NE(output.err.find("scene.path"), std::string::npos) << output.err;
}

TEST(WorkPrecision, ShowsTheOrderOfCollocation) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();

  const Output output =
      run({"work-precision", scene("base"), "--json", "--quiet", "--out", out,
           "--set",
           "work_precision={methods: [{rolling_time: [1, 2]}, "
           "extremal], meshes: [10, 20, 30, 40], repetitions: 1}"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json document = json::parse(output.out);
  EXPECT_NEAR(document["reference"]["tau"], 5.093444466618, 5e-12);
  for (const int p : {1, 2}) {
    const json line =
        find(document["lines"], "id", "rolling_time_" + std::to_string(p));
    ASSERT_FALSE(line.is_null());
    ASSERT_EQ(line["points"].size(), 4U);
    // Gauss collocation has order 2p. Over two halvings the terms of higher
    // order that the coarsest mesh still has move the slope by less than half.
    EXPECT_NEAR(line["observed_order"]["order"], 2.0 * p, 0.5);
    EXPECT_EQ(line["observed_order"]["points"], 4);
    // The path between nodes has order p + 1 (docs/theory.md, section 12); on
    // four times as many elements its error is less by 2^(p + 1) at least.
    const json &coarse = line["points"][0], fine = line["points"][3];
    EXPECT_LT(fine["path_error"].get<double>(),
              coarse["path_error"].get<double>() / std::pow(2.0, p + 1));
    EXPECT_GT(coarse["energy_drift"], fine["energy_drift"]);
  }
  const json extremal = find(document["lines"], "id", "extremal");
  EXPECT_TRUE(extremal["points"][0]["path_error"].is_null())
      << "it is the reference";
  for (const char* name :
       {"work_precision.svg", "work_precision.csv", "work_precision.gp",
        "work_precision_mesh.svg", "work_precision_path.svg",
        "work_precision_energy.svg", "work_precision.json", "index.html"}) {
    EXPECT_TRUE(std::filesystem::exists(out + "/" + name)) << name;
  }
  EXPECT_EQ(run({"work-precision", scene("base"), "--out", out}).code, 6)
      << "existing files are kept";
}

TEST(WorkPrecision, TellsNoOrderOfThreeMeshes) {
  const Output output =
      run({"work-precision", scene("bead"), "--json", "--quiet", "--set",
           "work_precision={methods: [{rolling_time: [1]}], meshes: [10, 20, "
           "40], repetitions: 1}"});

  ASSERT_EQ(output.code, 0) << output.err;
  EXPECT_TRUE(json::parse(output.out)["lines"][0]["observed_order"].is_null());
}

TEST(WorkPrecision, WhatHasNoResultIsAPointWithACause) {
  const Output output =
      run({"work-precision", scene("faster_than_bead"), "--json", "--quiet",
           "--set",
           "work_precision={methods: [{rolling_time: [1]}, {fsolve: [rest]}], "
           "meshes: [8], repetitions: 1}"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json point = json::parse(output.out)["lines"][1]["points"][0];
  EXPECT_EQ(point["outcome"], "failed");
  EXPECT_NE(point["cause"].get<std::string>().find("no good progress"),
            std::string::npos);
  EXPECT_TRUE(point["error"].is_null());
}

TEST(WorkPrecision, LeavesMeshesThatAreTooSmallToCollocation) {
  const Output output =
      run({"work-precision", scene("base"), "--json", "--quiet", "--set",
           "work_precision={methods: [{rolling_time: [3]}, {fsolve: [rest]}], "
           "meshes: [4, 8], repetitions: 1}"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json lines = json::parse(output.out)["lines"];
  EXPECT_EQ(lines[0]["points"].size(), 2U);
  ASSERT_EQ(lines[1]["points"].size(), 1U);
  EXPECT_EQ(lines[1]["points"][0]["mesh"], 8);
}

TEST(WorkPrecision, UnderLimitsFittedArcsHaveTheOrderOfRadauCollocation) {
  const Output output =
      run({"work-precision", scene("friction"), "--json", "--quiet", "--set",
           "work_precision={methods: [{rolling_time: [2]}, adaptive, "
           "arc_length, extremal], meshes: [32, 64, 128, 256], tolerances: "
           "[1e-4], repetitions: 1}"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json document = json::parse(output.out);
  // By the indirect method outside this project (docs/validation.md), to half
  // a unit of its last digit.
  EXPECT_NEAR(document["reference"]["tau"], 5.083389161786, 1e-12);
  const json& lines = document["lines"];
  ASSERT_EQ(lines.size(), 2U) << "what solves no limited scene is left out";
  // Radau IIA has order 2p − 1; a mesh of 32 elements on five arcs has parts
  // of a few elements, whose higher terms move the slope by less than half.
  EXPECT_NEAR(lines[0]["observed_order"]["order"], 3.0, 0.5);
  const json point = lines[1]["points"][0];
  EXPECT_EQ(point["wanted_error"], 1e-4);
  EXPECT_TRUE(point["mesh"].is_null());
  EXPECT_LT(point["error"], 1e-4);
  EXPECT_EQ(document["reference"]["method"], "extremal")
      << "not the program itself";
  EXPECT_LT(point["path_error"], 1e-4);
  // The search for the arcs is part of the start, which is part of all.
  EXPECT_GT(point["start_cpu_seconds"]["median"], 0.0);
  EXPECT_LT(point["start_cpu_seconds"]["median"],
            point["cpu_seconds"]["median"]);
  const json left_out = document["left_out"];
  ASSERT_EQ(left_out.size(), 2U);
  EXPECT_EQ(left_out[0]["id"], "arc_length");
  EXPECT_NE(left_out[0]["reason"].get<std::string>().find("straight pieces"),
            std::string::npos)
      << left_out[0];
}

TEST(WorkPrecision, WithoutAReferenceThereIsNothing) {
  const Output output =
      run({"work-precision", scene("base"), "--json", "--set",
           "scene.body.radius=2", "--set", "scene.finish.L=0.5"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(json::parse(output.out)["status"], "no_reference");
  EXPECT_NE(output.err.find("no reference"), std::string::npos) << output.err;
}

}  // namespace
}  // namespace brachisto
