// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// --out and --force.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
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
using testing::content;
using testing::names;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

const std::string kWritten = paper_problem("fig06_uniform_cylinder");
// Solves for minutes, unless it is refused before.
const std::string kLarge =
    "discretisation={formulation: rolling_time, degree: 5, elements: 200000}";
// Processor time that a command takes which refuses it, with much to spare; the
// solve takes several times as much.
constexpr double kLessThanLarge = 0.5;

using FileNames = std::set<std::string>;
const FileNames kAll{"result.json", "trajectory.csv", "path.csv",
                     "path.gp",     "path.svg",       "index.html"};

TEST(Out, WritesResultTrajectoryAndPicture) {
  const ScratchDirectory scratch;
  const fs::path out = scratch.path() / "new" / "results";

  const Output output =
      run({"solve", kWritten, "--json", "--out", out.string()});

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
        {"solve", kWritten, "--out", out.string(), "--set", kLarge});

    const auto output = process.wait();

    ASSERT_TRUE(output);
    EXPECT_LT(output->cpu_seconds, kLessThanLarge) << "it solves";
    EXPECT_EQ(output->code, 6);
    EXPECT_NE(output->err.find("--force"), std::string::npos) << output->err;
    EXPECT_EQ(content(out / name), "precious");
    EXPECT_EQ(names(out), FileNames{name});
  }
}

TEST(Out, RefusesADirectoryThatCannotBeMadeBeforeItSolves) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("file", "text");
  testing::Process process(
      {"solve", kWritten, "--out", file + "/below", "--set", kLarge});

  const auto output = process.wait();

  ASSERT_TRUE(output);
  EXPECT_LT(output->cpu_seconds, kLessThanLarge) << "it solves";
  EXPECT_EQ(output->code, 6);
}

TEST(Out, ReplacesResultsWithForce) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kWritten, "--out", out}).code, 0);

  const Output output = run({"solve", kWritten, "--out", out, "--force",
                             "--set", "scene.finish.L=4", "--json"});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(names(out), kAll);
  EXPECT_EQ(content(fs::path(out) / "result.json"), output.out);
}

TEST(Out, OfAnUnverifiedSolveIsTheResultOnly) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();

  const Output output =
      run({"solve", kWritten, "--out", out, "--set", "scene.body.radius=2"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(names(out), FileNames{"result.json"});
  const json result = json::parse(content(fs::path(out) / "result.json"));
  EXPECT_EQ(result["status"], "no_admissible_path");
}

TEST(Out, LeavesNoStalePathBesideAResultThatHasNone) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kWritten, "--out", out}).code, 0);

  const Output output = run({"solve", kWritten, "--out", out, "--force",
                             "--set", "scene.body.radius=2"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(names(out), FileNames{"result.json"});
}

TEST(Show, WritesTheSamePageAnew) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kWritten, "--out", out}).code, 0);
  const std::string page = content(scratch.path() / "index.html");
  fs::remove(scratch.path() / "index.html");

  const Output output = run({"show", out});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(output.out, out + "/index.html\n");
  EXPECT_EQ(content(scratch.path() / "index.html"), page);
  EXPECT_EQ(names(scratch.path()), kAll);
}

TEST(Show, WritesTheMotionAsAPictureOnRequest) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  ASSERT_EQ(run({"solve", kWritten, "--out", out, "--gif"}).code, 0);
  const std::string gif = content(scratch.path() / "motion.gif");
  EXPECT_TRUE(gif.starts_with("GIF89a"));

  const Output output = run({"show", out, "--gif", "--quiet"});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(output.out, "");
  EXPECT_EQ(content(scratch.path() / "motion.gif"), gif);
}

TEST(Show, RefusesADirectoryWithoutAResult) {
  const ScratchDirectory scratch;
  const std::string out = scratch.path().string();
  const auto refusal = [&] {
    const Output output = run({"show", out});
    EXPECT_EQ(output.code, 6);
    EXPECT_FALSE(fs::exists(scratch.path() / "index.html"));
    return output.err;
  };
  const auto put = [&](const char* name, const std::string& text) {
    std::ofstream(scratch.path() / name, std::ios::binary) << text;
  };
  const auto says = [](const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
  };

  EXPECT_TRUE(says(refusal(), "has no result.json"));
  put("sweep.sqlite", "");
  EXPECT_TRUE(says(refusal(), "sweep.sqlite: is empty"));
  put("result.json", "{}");
  EXPECT_TRUE(says(refusal(), "no result of `brachisto solve`"));
  put("result.json",
      run({"solve", kWritten, "--json", "--set", "scene.body.radius=2"}).out);
  EXPECT_TRUE(says(refusal(), "not verified"));
  put("result.json", run({"solve", kWritten, "--json"}).out);
  EXPECT_TRUE(says(refusal(), "has no trajectory.csv"));
  ASSERT_EQ(run({"solve", kWritten, "--out", out + "/whole"}).code, 0);
  const std::string whole =
      content(scratch.path() / "whole" / "trajectory.csv");
  put("trajectory.csv",
      whole.substr(0, whole.find('\n', whole.size() / 2) + 1));
  EXPECT_TRUE(says(refusal(), "and the motion of result.json at"));
  put("trajectory.csv", "x,z\n0,0\n");
  EXPECT_TRUE(says(refusal(), "trajectory.csv: line 1"));
  EXPECT_EQ(run({"show", out + "/nowhere"}).code, 6);
}

/// A problem file of those that race.
std::string starter(const char* name) {
  return std::string(BRACHISTO_PROBLEMS_DIR) + "/race/" + name + ".yaml";
}

TEST(Race, WritesOnePageAndTellsTheOrder) {
  const ScratchDirectory scratch;
  const fs::path page = scratch.path() / "new" / "race.html";

  const Output output =
      run({"race", starter("straight_track"), starter("bead"),
           starter("uniform_cylinder"), "--out", page.string()});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(names(page.parent_path()), FileNames{"race.html"});
  EXPECT_TRUE(content(page).starts_with("<!DOCTYPE html>"));
  const auto at = [&](const char* words) { return output.out.find(words); };
  EXPECT_LT(at("bead"), at("uniform cylinder"));
  EXPECT_LT(at("uniform cylinder"), at("straight track"));
  EXPECT_TRUE(output.out.ends_with(page.string() + "\n"));
}

TEST(Race, WritesNothingIfOneFails) {
  const ScratchDirectory scratch;
  const fs::path page = scratch.path() / "race.html";
  // B lies within the body at its start, which starts all the same where its
  // path is given.
  const std::string large = "scene.body.radius=2";

  const Output output =
      run({"race", starter("straight_track"), starter("uniform_cylinder"),
           "--set", large, "--out", page.string()});

  constexpr int kNotSolved = 4;
  EXPECT_EQ(output.code, kNotSolved);
  EXPECT_NE(output.err.find("uniform_cylinder.yaml: "), std::string::npos)
      << output.err;
  EXPECT_TRUE(names(scratch.path()).empty());
}

TEST(Race, RefusesOtherEndsOtherPagesAndTooFew) {
  const ScratchDirectory scratch;
  const std::string page = (scratch.path() / "race.html").string();
  const std::string near = paper_problem("fig12_L_2");

  const Output apart = run({"race", starter("bead"), near, "--out", page});
  const Output alone = run({"race", starter("bead"), "--out", page});
  EXPECT_EQ(apart.code, 3);
  EXPECT_NE(apart.err.find("fig12_L_2.yaml: scene.finish: the track runs from "
                           "(0, 0) to (2, 1), that of \"bead\""),
            std::string::npos)
      << apart.err;
  EXPECT_EQ(alone.code, 2);
  EXPECT_TRUE(names(scratch.path()).empty());

  std::ofstream(page) << "mine";
  EXPECT_EQ(run({"race", near, near, "--out", page}).code, 6);
  EXPECT_EQ(content(page), "mine");
  EXPECT_EQ(run({"race", near, near, "--out", page, "--force"}).code, 0);
  EXPECT_NE(content(page), "mine");
}

/// On one track v² = 2 g z/(1 + k) at each place of a uniform cylinder that
/// rolls from rest, and times are in proportion to √(1 + k).
TEST(Race, OnOneTrackTakesTimesByTheLawOfRolling) {
  const ScratchDirectory scratch;
  const std::string wheels = std::string(BRACHISTO_PROBLEMS_DIR) + "/wheels/";

  const Output output =
      run({"race", wheels + "disc.yaml", wheels + "hoop.yaml", "--same-track",
           "--out", (scratch.path() / "race.html").string()});

  ASSERT_EQ(output.code, 0) << output.err;
  const auto time_of = [&](const std::string& name) {
    return std::stod(output.out.substr(output.out.find(name) + name.size()));
  };
  // Times are printed to 1e-7 of them.
  constexpr double kOfSpline = 1e-6;
  EXPECT_NEAR(time_of("hoop") / time_of("disc"), std::sqrt(2.0 / 1.5),
              kOfSpline);
}

/// An off-centred body just fits into its own track at A.
TEST(Race, OnOneTrackAnEqualTakesTheSameTime) {
  const ScratchDirectory scratch;
  const std::string text =
      "scene: {body: {shape: cylinder, radius: 1/3, eta_m: 2/3, theta_m: -30 "
      "deg, k: 1/2}, finish: {L: 3, H: 1}}\n";

  const Output output = run({"race", scratch.file("one.yaml", text),
                             scratch.file("two.yaml", text), "--same-track",
                             "--out", (scratch.path() / "race.html").string()});

  ASSERT_EQ(output.code, 0) << output.err;
  // Either may come first, by rounding.
  const std::string time = "  1.137174 ";
  const std::size_t first = output.out.find(time);
  ASSERT_NE(first, std::string::npos) << output.out;
  EXPECT_NE(output.out.find(time, first + 1), std::string::npos) << output.out;
  EXPECT_NE(output.out.find("+0.000\n"), std::string::npos) << output.out;
}

TEST(Race, OnOneTrackRefusesOneThatDoesNotLeadFromAToB) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file(
      "one.yaml",
      "scene: {body: {shape: cylinder, radius: 1/3, k: 1/2}, contact: centre, "
      "finish: {L: 3, H: 1}}\n");

  const Output output = run({"race", file, file, "--same-track", "--out",
                             (scratch.path() / "race.html").string()});

  EXPECT_EQ(output.code, 3);
  EXPECT_NE(output.err.find("scene.contact: centre was read"),
            std::string::npos)
      << output.err;
}

TEST(Race, OnOneTrackRefusesAnotherFinishBeforeItSolves) {
  const ScratchDirectory scratch;
  const auto to = [&](const char* L) {
    return scratch.file(
        std::string("to") + L + ".yaml",
        std::string("scene: {body: {shape: bead}, finish: {L: ") + L +
            ", H: 1}}\n");
  };

  const Output output = run({"race", to("3"), to("4"), "--same-track", "--out",
                             (scratch.path() / "race.html").string()});

  EXPECT_EQ(output.code, 3);
  EXPECT_NE(output.err.find("scene.finish: the track runs to (4, 1), that of "
                            "\"to3\" to (3, 1)"),
            std::string::npos)
      << output.err;
}

TEST(Set, ReplacesValuesAndMayBeRepeated) {
  const Output output =
      run({"solve", kWritten, "--json", "--set", "scene.finish.L=2", "--set",
           "scene.body.k=1/4", "--set", "scene.finish.L=4"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json result = json::parse(output.out);
  EXPECT_EQ(result["scene"]["finish"]["L"], 4.0);
  EXPECT_EQ(result["scene"]["body"]["k"], 0.25);
}

}  // namespace
}  // namespace brachisto
