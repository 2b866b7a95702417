// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is said where: results to stdout, everything else to stderr.

#include <gtest/gtest.h>
#include <stdio.h>

#include <array>
#include <cstdio>
#include <string>

#include "app/command.hpp"

namespace brachisto {
namespace {

using testing::Output;
using testing::paper_problem;
using testing::run;

const std::string kProblem = paper_problem("fig06_uniform_cylinder");

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Texts, AResultGoesToStdout) {
  const Output output = run({"solve", kProblem});

  EXPECT_TRUE(says(output.out, "τ = T √(2g/H) = 5.115100653579")) << output.out;
  EXPECT_EQ(output.err, "");
}

TEST(Texts, QuietMeansNoStdout) {
  const Output solved = run({"solve", kProblem, "--quiet"});
  EXPECT_EQ(solved.code, 0);
  EXPECT_EQ(solved.out, "");
  EXPECT_EQ(solved.err, "");

  const Output failed =
      run({"solve", kProblem, "--quiet", "--set", "scene.body.radius=2"});
  EXPECT_EQ(failed.code, 4);
  EXPECT_EQ(failed.out, "");
  EXPECT_TRUE(says(failed.err, "inside the")) << failed.err;

  const Output validated = run({"validate", kProblem, "--quiet"});
  EXPECT_EQ(validated.code, 0);
  EXPECT_EQ(validated.out, "");
}

TEST(Texts, QuietTellsOfAResultThatIsNotVerified) {
  const Output output =
      run({"solve", paper_problem("fig04_reference_case"), "--quiet", "--set",
           "discretisation={degree: 2, elements: 8, tolerance: 1e-9}"});

  EXPECT_EQ(output.code, 4);
  EXPECT_EQ(output.out, "");
  EXPECT_NE(output.err, "");
}

TEST(Texts, TheLogGoesToStderr) {
  const Output output = run({"solve", kProblem, "--verbose"});

  EXPECT_EQ(output.code, 0);
  EXPECT_TRUE(says(output.err, "inf_pr")) << output.err;
  EXPECT_FALSE(says(output.out, "inf_pr")) << output.out;
}

TEST(Texts, TheVersionNamesEverythingNumbersDependOn) {
  const Output output = run({"--version"});

  EXPECT_TRUE(output.out.starts_with("brachisto ")) << output.out;
  for (const char* part :
       {"\nIpopt 3.", "\nMUMPS ", "\nBLAS ", "\nSuiteSparse ", "\ncompiler "}) {
    EXPECT_TRUE(says(output.out, part)) << part << " in\n" << output.out;
  }
  EXPECT_FALSE(says(output.out, "unknown")) << output.out;
  EXPECT_EQ(output.err, "");
}

TEST(Texts, HelpHasExamples) {
  for (const Output& output :
       {run({"--help"}), run({"solve", "--help"}), run({"validate", "--help"}),
        run({"solve", "-h"})}) {
    EXPECT_EQ(output.code, 0);
    EXPECT_TRUE(says(output.out, "Examples:")) << output.out;
    EXPECT_TRUE(says(output.out, "brachisto solve ") ||
                says(output.out, "brachisto validate "))
        << output.out;
    EXPECT_EQ(output.err, "");
  }
}

TEST(Texts, HelpOfSolveTellsTheExitCodes) {
  const Output output = run({"solve", "--help"});

  EXPECT_TRUE(says(output.out, "Exit codes")) << output.out;
  EXPECT_TRUE(says(output.out, "130/143")) << output.out;
}

TEST(Texts, ValidateShowsTheEffectiveInput) {
  const Output output = run({"validate", kProblem});

  EXPECT_EQ(output.code, 0);
  EXPECT_TRUE(says(output.out, "valid")) << output.out;
  EXPECT_TRUE(says(output.out, "\"iterations\": 3000")) << output.out;
}

/// What a command of the shell writes to a terminal.
std::string in_a_terminal(const std::string& command) {
  const std::string line = "script -qec '" + command + "' /dev/null";
  FILE* terminal = ::popen(line.c_str(), "r");
  if (terminal == nullptr) return "no terminal";
  std::string text;
  std::array<char, 4096> part{};
  while (std::fgets(part.data(), part.size(), terminal) != nullptr) {
    text += part.data();
  }
  ::pclose(terminal);
  return text;
}

TEST(Texts, TheVerdictHasAColourIfTheTerminalWantsOne) {
  const std::string solve = BRACHISTO_APP " solve " + kProblem;
  const std::string green = "\033[32m  verdict";

  const std::string shown = in_a_terminal("TERM=xterm NO_COLOR= " + solve);

  EXPECT_TRUE(says(shown, green)) << shown;
  EXPECT_TRUE(says(shown, "feasible\033[0m")) << shown;
  EXPECT_FALSE(says(in_a_terminal("TERM=xterm NO_COLOR=1 " + solve), "\033["));
  EXPECT_FALSE(says(in_a_terminal("TERM=dumb " + solve), "\033["));
  EXPECT_FALSE(says(run({"solve", kProblem}).out, "\033["));
}

}  // namespace
}  // namespace brachisto
