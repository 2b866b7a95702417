// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// brachisto nlp: what it writes, and what it refuses.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
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

const std::string kScene = paper_problem("fig04_reference_case");
const std::string kInASphere =
    BRACHISTO_PROBLEMS_DIR "/worlds/small_planet.yaml";

std::size_t lines_in(const fs::path& file) {
  std::ifstream in(file);
  std::size_t count = 0;
  for (std::string line; std::getline(in, line);) ++count;
  return count;
}

TEST(Nlp, WritesAFileWithTheSizeOfTheProgramThatWasSolved) {
  const ScratchDirectory scratch;
  const fs::path file = scratch.path() / "case.nl";

  const Output output = run({"nlp", kScene, "--json", "--out", file.string()});

  ASSERT_EQ(output.code, 0) << output.err;
  const json told = json::parse(output.out);
  const json solved = json::parse(run({"solve", kScene, "--json"}).out);
  const json& program = told.at("program");
  for (const char* key : {"variables", "constraints"}) {
    EXPECT_EQ(program.at(key), solved.at(key)) << key;
  }
  // The one is summed point by point, the other node by node.
  EXPECT_DOUBLE_EQ(program.at("transit_time").get<double>(),
                   solved.at("transit_time").get<double>());
  EXPECT_EQ(program.at("start"), "guess");
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  EXPECT_TRUE(line.starts_with("g3 ")) << line;
  int variables = 0, constraints = 0, objectives = 0;
  in >> variables >> constraints >> objectives;
  EXPECT_EQ(program.at("variables"), variables);
  EXPECT_EQ(program.at("constraints"), constraints);
  EXPECT_EQ(objectives, 1);
  const auto count = [](int i) { return static_cast<std::size_t>(i); };
  EXPECT_EQ(lines_in(scratch.path() / "case.col"), count(variables));
  EXPECT_EQ(lines_in(scratch.path() / "case.row"), count(constraints) + 1);
  std::ifstream described(scratch.path() / "case.json");
  EXPECT_EQ(json::parse(described), program);
}

TEST(Nlp, WritesMatricesIntoADirectoryThatItMakes) {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "matrices";

  const Output output = run(
      {"nlp", kInASphere, "--format", "matrices", "--out", directory.string()});

  ASSERT_EQ(output.code, 0) << output.err;
  for (const char* name :
       {"jacobian.mtx", "hessian.mtx", "kkt.mtx", "gradient.mtx", "x.mtx",
        "lambda.mtx", "constraints.mtx", "program.row", "program.col",
        "program.json"}) {
    EXPECT_TRUE(fs::exists(directory / name)) << name;
  }
  EXPECT_NE(output.out.find("jacobian.mtx"), std::string::npos) << output.out;
}

TEST(Nlp, ReplacesNothingUnlessItMay) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("case.nl", "mine");

  const Output refused = run({"nlp", kScene, "--out", file});
  const auto size = fs::file_size(file);

  EXPECT_EQ(refused.code, 6);
  EXPECT_NE(refused.err.find("--force"), std::string::npos) << refused.err;
  EXPECT_EQ(size, 4U);
  EXPECT_EQ(run({"nlp", kScene, "--quiet", "--force", "--out", file}).code, 0);
  EXPECT_GT(fs::file_size(file), size);
}

TEST(Nlp, RefusesWhatHasNoProgramWithTheReason) {
  const ScratchDirectory scratch;
  const std::string file = (scratch.path() / "case.nl").string();
  struct Case {
    std::vector<std::string> arguments;
    const char* reason;
  };
  for (const auto& [arguments, reason] :
       {Case{{kScene, "--set", "solver.method=extremal"}, "ipopt"},
        Case{{kScene, "--set", "scene.path={shape: straight}"}, "optimised"}}) {
    std::vector<std::string> all{"nlp", "--out", file};
    all.insert(all.end(), arguments.begin(), arguments.end());

    const Output output = run(all);

    EXPECT_EQ(output.code, 3) << output.err;
    EXPECT_NE(output.err.find(reason), std::string::npos) << output.err;
    EXPECT_FALSE(fs::exists(file));
  }
}

TEST(Nlp, WritesNothingWithoutAnAnswer) {
  const ScratchDirectory scratch;
  const std::string file = (scratch.path() / "case.nl").string();

  const Output output = run(
      {"nlp", kScene, "--set", "scene.body.radius=2", "--json", "--out", file});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(json::parse(output.out).at("program"), nullptr);
  EXPECT_NE(output.err, "");
  EXPECT_FALSE(fs::exists(file));
}

TEST(Nlp, IsToldWhatToWriteAndWhere) {
  EXPECT_EQ(run({"nlp", kScene}).code, 2);
  EXPECT_EQ(run({"nlp", kScene, "--out", "x", "--format", "mps"}).code, 2);
  for (const std::vector<std::string>& of_writing :
       {std::vector<std::string>{"--format", "nl"},
        {"--start", "guess"},
        {"--force"}}) {
    std::vector<std::string> words{"nlp", kScene, "--check", "x.sol"};
    words.insert(words.end(), of_writing.begin(), of_writing.end());
    EXPECT_EQ(run(words).code, 2) << of_writing.front();
  }
}

TEST(Nlp, ChecksAFileOrSaysWhyNot) {
  const ScratchDirectory scratch;
  const fs::path file = scratch.path() / "case.sol";
  std::ofstream(file) << "no answer\n";
  const Output no_answer = run({"nlp", kScene, "--check", file.string()});
  EXPECT_EQ(no_answer.code, 3);
  EXPECT_NE(no_answer.err.find("case.sol:1:1: no .sol file in text"),
            std::string::npos)
      << no_answer.err;

  EXPECT_EQ(run({"nlp", kScene, "--check", "nothing.sol"}).code, 6);
  const Output both =
      run({"nlp", kScene, "--check", file.string(), "--out", "case.nl"});
  EXPECT_EQ(both.code, 2);
  EXPECT_NE(both.err.find("one of them"), std::string::npos) << both.err;

  // A scene without an answer has nothing to check against.
  std::ofstream(file) << "\nOptions\n3\n1\n1\n0\n0\n0\n0\n0\n0\n";
  const Output unanswered = run({"nlp", kScene, "--set", "scene.body.radius=2",
                                 "--check", file.string()});
  EXPECT_EQ(unanswered.code, 4);
  EXPECT_TRUE(unanswered.out.empty()) << unanswered.out;
  EXPECT_NE(unanswered.err.find("nothing to check the answer against"),
            std::string::npos)
      << unanswered.err;
}

TEST(Derivatives, AgreeAndTellOfTheProgram) {
  const Output output = run({"derivatives", kScene, "--json"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json told = json::parse(output.out);
  const json solved = json::parse(run({"solve", kScene, "--json"}).out);
  EXPECT_EQ(told.at("variables"), solved.at("variables"));
  EXPECT_EQ(told.at("constraints"), solved.at("constraints"));
  EXPECT_EQ(told.at("inertia").at("minimum"), true);
  EXPECT_GT(told.at("chain").at("links").get<int>(), 0);
}

TEST(Derivatives, AgreeNextToRestOnFineMeshes) {
  // The first place lies 1e-6 of the track from A, where the time is a root of
  // it: the step of differences has to be smaller still.
  for (const std::string& scene :
       {kScene, std::string(BRACHISTO_PROBLEMS_DIR "/case.yaml")}) {
    const Output output =
        run({"derivatives", scene, "--set",
             "discretisation.formulation=arc_length", "--json"});

    EXPECT_EQ(output.code, 0) << scene << output.out;
    EXPECT_EQ(json::parse(output.out).at("agrees"), true);
  }
}

TEST(Table, HasARowForEachScene) {
  const std::string refused = BRACHISTO_PROBLEMS_DIR "/hard/eta_m_1.yaml";

  const Output output = run({"table", kScene, refused, "--json", "--quiet"});

  ASSERT_EQ(output.code, 0) << output.err;
  const json rows = json::parse(output.out);
  ASSERT_EQ(rows.size(), 2u);
  const json solved = json::parse(run({"solve", kScene, "--json"}).out);
  EXPECT_EQ(rows[0].at("tau"), solved.at("tau"));
  EXPECT_EQ(rows[0].at("verified"), true);
  EXPECT_EQ(rows[1].at("outcome"), "refused");
  EXPECT_EQ(run({"table", "nothing.yaml", "--quiet"}).code, 6);
  // Before anything is solved.
  const Output late = run({"table", kScene, "nothing.yaml"});
  EXPECT_EQ(late.code, 6);
  EXPECT_EQ(late.err.find("1 of 2"), std::string::npos) << late.err;
}

}  // namespace
}  // namespace brachisto
