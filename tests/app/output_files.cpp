// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// --out and --force.

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "app/command.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

const std::string kProblem = paper_problem("fig06_uniform_cylinder");
// Solves for minutes, unless it is refused before.
const std::string kLarge =
    "discretisation={formulation: rolling_time, degree: 5, elements: 200000}";

std::string content(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::set<std::string> names(const fs::path& path) {
  std::set<std::string> out;
  for (const auto& entry : fs::directory_iterator(path)) {
    out.insert(entry.path().filename().string());
  }
  return out;
}

using Names = std::set<std::string>;
const Names kAll{"result.json", "trajectory.csv", "path.csv", "path.gp",
                 "path.svg"};

TEST(Out, WritesResultTrajectoryAndPicture) {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "new" / "results";

  const Output output =
      run({"solve", kProblem, "--json", "--out", out.string()});

  ASSERT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(names(out), kAll);
  EXPECT_EQ(content(out / "result.json"), output.out);
  EXPECT_TRUE(content(out / "trajectory.csv").starts_with("u,t,x_c,z_c,"));
  EXPECT_TRUE(content(out / "path.svg").starts_with("<?xml "));
}

TEST(Out, RefusesExistingResultsBeforeItSolves) {
  const ScratchDirectory scratch;
  for (const std::string& name : kAll) {
    const fs::path out = scratch.path() / name;
    fs::create_directory(out);
    std::ofstream(out / name) << "precious";
    testing::Process process(
        {"solve", kProblem, "--out", out.string(), "--set", kLarge});

    const auto output = process.wait(std::chrono::seconds(10));

    ASSERT_TRUE(output) << "it solves";
    EXPECT_EQ(output->code, 6);
    EXPECT_NE(output->err.find("--force"), std::string::npos) << output->err;
    EXPECT_EQ(content(out / name), "precious");
    EXPECT_EQ(names(out), Names{name});
  }
}

TEST(Out, RefusesADirectoryThatCannotBeMadeBeforeItSolves) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("file", "text");
  testing::Process process(
      {"solve", kProblem, "--out", file + "/below", "--set", kLarge});

  const auto output = process.wait(std::chrono::seconds(5));

  ASSERT_TRUE(output) << "it solves";
  EXPECT_EQ(output->code, 6);
}

TEST(Out, ReplacesResultsWithForce) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kProblem, "--out", out}).code, 0);

  const Output output = run({"solve", kProblem, "--out", out, "--force",
                             "--set", "scene.finish.L=4", "--json"});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(names(out), kAll);
  EXPECT_EQ(content(fs::path(out) / "result.json"), output.out);
}

TEST(Out, OfAnUnverifiedSolveIsTheResultOnly) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();

  const Output output =
      run({"solve", kProblem, "--out", out, "--set", "scene.body.radius=2"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(names(out), Names{"result.json"});
  const json result = json::parse(content(fs::path(out) / "result.json"));
  EXPECT_EQ(result["status"], "no_admissible_path");
}

TEST(Out, LeavesNoStalePathBesideAResultThatHasNone) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kProblem, "--out", out}).code, 0);

  const Output output = run({"solve", kProblem, "--out", out, "--force",
                             "--set", "scene.body.radius=2"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(names(out), Names{"result.json"});
}

TEST(Set, ReplacesValuesAndMayBeRepeated) {
  const Output output =
      run({"solve", kProblem, "--json", "--set", "scene.finish.L=2", "--set",
           "scene.body.k=1/4", "--set", "scene.finish.L=4"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json result = json::parse(output.out);
  EXPECT_EQ(result["scene"]["finish"]["L"], 4.0);
  EXPECT_EQ(result["scene"]["body"]["k"], 0.25);
}

}  // namespace
}  // namespace brachisto
