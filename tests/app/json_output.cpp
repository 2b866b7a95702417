// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// --json puts exactly one JSON document on stdout, whatever happens.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

/// The one document; discarded if there is none, or another one after it.
json document(const Output& output) {
  return json::parse(output.out, nullptr, false);
}

TEST(JsonOutput, HasTheAnswer) {
  const Output output =
      run({"solve", paper_problem("fig04_reference_case"), "--json"});

  const json result = document(output);
  ASSERT_FALSE(result.is_discarded()) << output.out;
  EXPECT_EQ(result["verified"], true);
  EXPECT_NEAR(result["tau"].get<double>(),
              testing::reference("reference_case").tau, 1e-9 * 5.1);
  EXPECT_EQ(output.err, "");
}

TEST(JsonOutput, HasTheWarningsThatStderrHas) {
  const Output output = run({"solve", paper_problem("fig04_reference_case"),
                             "--json", "--set", "scene.body.theta_m=720 deg"});

  const json result = document(output);
  ASSERT_FALSE(result.is_discarded()) << output.out;
  EXPECT_EQ(result["verified"], true);
  ASSERT_EQ(result["warnings"].size(), 1U);
  const std::string warning = result["warnings"][0];
  EXPECT_NE(warning.find("\"720 deg\" is more than a turn"), std::string::npos)
      << warning;
  EXPECT_EQ(output.err, "warning: " + warning + "\n");
  EXPECT_NEAR(result["tau"].get<double>(),
              testing::reference("reference_case").tau, 1e-9 * 5.1);
}

TEST(JsonOutput, OfValidateIsTheEffectiveInput) {
  const Output output = run({"validate", paper_problem("fig12_L_2"), "--json"});

  const json result = document(output);
  ASSERT_FALSE(result.is_discarded()) << output.out;
  EXPECT_EQ(result["valid"], true);
  EXPECT_EQ(result["scene"]["finish"]["L"], 2.0);
}

TEST(JsonOutput, IsOneDocumentInEveryCase) {
  const ScratchDirectory scratch;
  const std::string good = paper_problem("fig06_uniform_cylinder");
  const std::string bad = scratch.file("bad.yaml", "scene: {bodi: 3}\n");
  const std::string taken = scratch.file("taken", "");
  struct Case {
    std::vector<std::string> arguments;
    int code;
    std::string status;
  };
  for (const Case& c : {
           Case{{"solve", good}, 0, "solved"},
           Case{{"solve", good, "--quiet"}, 0, "solved"},
           Case{{"solve", good, "--verbose"}, 0, "solved"},
           Case{{"solve", bad}, 3, "bad_input"},
           Case{{"validate", bad}, 3, "bad_input"},
           Case{{"solve", good, "--set", "scene.body.k=7"}, 3, "bad_input"},
           Case{{"solve", good, "--set", "scene.body.radius=2"},
                4,
                "no_admissible_path"},
           Case{{"solve", scratch.path().string() + "/missing"}, 6, "io_error"},
           Case{{"solve", good, "--out", taken}, 6, "io_error"},
           Case{{"solve", good, "--set", "solver.limits.seconds=1e-6"},
                7,
                "time_limit"},
       }) {
    std::vector<std::string> arguments = c.arguments;
    arguments.emplace_back("--json");

    const Output output = run(arguments);

    const json result = document(output);
    ASSERT_FALSE(result.is_discarded())
        << ::testing::PrintToString(arguments) << '\n'
        << output.out;
    EXPECT_EQ(output.code, c.code) << ::testing::PrintToString(arguments);
    EXPECT_EQ(result["status"], c.status);
    EXPECT_EQ(result["verified"], c.code == 0);
    EXPECT_TRUE(result.contains("schema_version"));
  }
}

TEST(JsonOutput, IsOneDocumentForAWrongCommandLineToo) {
  const Output output = run({"solve", "--json"});

  EXPECT_EQ(output.code, 2);
  EXPECT_FALSE(document(output).is_discarded()) << output.out;
}

TEST(JsonOutput, ListsTheMistakesOfABadFileWithTheirPlaces) {
  const ScratchDirectory scratch;
  const std::string file =
      scratch.file("bad.yaml",
                   "scene:\n"
                   "  body: {shape: cylinder, radius: -1, eta_m: 0, k: 0.5}\n"
                   "  finish: {L: 3, H: 1}\n"
                   "solvre: {}\n");

  const Output output = run({"solve", file, "--json"});

  const json result = document(output);
  ASSERT_FALSE(result.is_discarded()) << output.out;
  ASSERT_EQ(result["errors"].size(), 2u) << output.out;
  EXPECT_EQ(result["errors"][0]["key"], "scene.body.radius");
  EXPECT_EQ(result["errors"][0]["line"], 2);
  EXPECT_EQ(result["errors"][1]["key"], "solvre");
  EXPECT_EQ(result["errors"][1]["line"], 4);
}

TEST(JsonOutput, SurvivesBytesThatAreNoText) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("bad.yaml", "scene: \xFF\xFE\n");

  const Output output = run({"solve", file, "--json"});

  EXPECT_EQ(output.code, 3);
  EXPECT_FALSE(document(output).is_discarded()) << output.out;
}

TEST(JsonOutput, SurvivesAFileNameThatIsNoText) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("\xFF.yaml", "scene: {}\n");

  const Output output = run({"validate", file, "--json"});

  EXPECT_EQ(output.code, 3);
  EXPECT_FALSE(document(output).is_discarded()) << output.out;
}

}  // namespace
}  // namespace brachisto
