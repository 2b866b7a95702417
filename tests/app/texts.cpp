// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What is said where: results to stdout, everything else to stderr.

#include <gtest/gtest.h>
#include <stdio.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <tuple>

#include "app/command.hpp"

namespace brachisto {
namespace {

using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::says;

const std::string kCylinder = paper_problem("fig06_uniform_cylinder");

TEST(Texts, AResultGoesToStdout) {
  const Output output = run({"solve", kCylinder});

  EXPECT_TRUE(says(output.out, "τ = T √(2g/H) = 5.115100653579")) << output.out;
  EXPECT_EQ(output.err, "");
}

TEST(Texts, QuietMeansNoStdout) {
  const Output solved = run({"solve", kCylinder, "--quiet"});
  EXPECT_EQ(solved.code, 0);
  EXPECT_EQ(solved.out, "");
  EXPECT_EQ(solved.err, "");

  const Output failed =
      run({"solve", kCylinder, "--quiet", "--set", "scene.body.radius=2"});
  EXPECT_EQ(failed.code, 4);
  EXPECT_EQ(failed.out, "");
  EXPECT_TRUE(says(failed.err, "inside the")) << failed.err;

  const Output validated = run({"validate", kCylinder, "--quiet"});
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
  const Output output = run({"solve", kCylinder, "--verbose"});

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
  const Output output = run({"validate", kCylinder});

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
  const std::string solve = BRACHISTO_APP " solve " + kCylinder;
  const std::string green = "\033[32m  verdict";

  const std::string shown = in_a_terminal("TERM=xterm NO_COLOR= " + solve);

  EXPECT_TRUE(says(shown, green)) << shown;
  EXPECT_TRUE(says(shown, "feasible\033[0m")) << shown;
  EXPECT_FALSE(says(in_a_terminal("TERM=xterm NO_COLOR=1 " + solve), "\033["));
  EXPECT_FALSE(says(in_a_terminal("TERM=dumb " + solve), "\033["));
  EXPECT_FALSE(says(run({"solve", kCylinder}).out, "\033["));
}

TEST(Texts, ColoursComeAndGoAsTheFlagSays) {
  const std::string solve = BRACHISTO_APP " solve " + kCylinder;

  const Output always = run({"solve", kCylinder, "--color", "always"});
  EXPECT_TRUE(says(always.out, "\033[32m  verdict")) << always.out;
  EXPECT_FALSE(
      says(in_a_terminal("TERM=xterm NO_COLOR= " + solve + " --color=never"),
           "\033["));
  EXPECT_TRUE(
      says(in_a_terminal("TERM=dumb NO_COLOR=1 " + solve + " --color=always"),
           "\033[32m"));
  EXPECT_FALSE(says(run({"solve", kCylinder, "--color", "auto"}).out, "\033["));
  const Output wrong = run({"solve", kCylinder, "--color", "sometimes"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(says(wrong.err, "{auto,always,never}")) << wrong.err;
}

TEST(Texts, WhatFailedHasTheColourOfTheVerdict) {
  const Output output =
      run({"solve", paper_problem("fig04_reference_case"), "--set",
           "discretisation={degree: 2, elements: 8, tolerance: 1e-9}",
           "--color", "always"});

  EXPECT_EQ(output.code, 4);
  EXPECT_TRUE(says(output.out, "\033[31m  verdict")) << output.out;
  EXPECT_TRUE(says(output.out, "\033[31m  failed check")) << output.out;
}

TEST(Texts, ErrorsAndWarningsHaveARedOrAYellowHead) {
  const Output usage = run({"solve", "--jsno", "--color=always"});
  EXPECT_TRUE(usage.err.starts_with("\033[31mbrachisto solve:\033[0m --jsno"))
      << usage.err;

  const Output input = run({"validate", kCylinder, "--set", "scene.body.kk=1",
                            "--set", "scene.finish.L=-1", "--color=always"});
  EXPECT_EQ(input.code, 3);
  EXPECT_TRUE(input.err.starts_with("\033[31m--set scene.body.kk=1:\033[0m "))
      << input.err;
  EXPECT_TRUE(says(input.err, "\n\033[31m--set scene.finish.L=-1:\033[0m "))
      << input.err;

  const Output warned =
      run({"validate", paper_problem("fig04_reference_case"), "--set",
           "scene.body.theta_m=370 deg", "--color=always"});
  EXPECT_EQ(warned.code, 0);
  EXPECT_TRUE(warned.err.starts_with("\033[33mwarning:\033[0m ")) << warned.err;

  // The document of --json has none.
  const Output json = run({"solve", "--jsno", "--json", "--color=always"});
  EXPECT_FALSE(says(json.out, "\033")) << json.out;
  EXPECT_FALSE(says(json.out, "\\u001b")) << json.out;
}

/// The columns of a line of a table in Markdown: bars that are not escaped.
std::size_t bars_of(const std::string& line) {
  std::size_t bars = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '|' && (i == 0 || line[i - 1] != '\\')) ++bars;
  }
  return bars;
}

TEST(Markdown, TablesOfVerbsHaveTheirColumns) {
  const testing::ScratchDirectory scratch;
  const std::string map = (scratch.path() / "map").string();
  const std::string file =
      scratch.file("map.yaml",
                   "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n"
                   "sweep: {scene.finish.L: [2, 3]}\n");
  ASSERT_EQ(run({"sweep", file, "--out", map, "--quiet"}).code, 0);

  const Output exported = run({"export", map, "--markdown"});
  const Output compared = run({"compare", kCylinder, "--nodes", "11",
                               "--repetitions", "1", "--quiet", "--markdown"});
  const Output shown = run({"compare", kCylinder, "--nodes", "11",
                            "--repetitions", "1", "--markdown"});

  EXPECT_EQ(compared.out, "");
  for (const auto& [output, least, words] :
       {std::tuple{exported, 4u, "| scene | scene.finish.L | status "},
        std::tuple{shown, 6u, "| method "}}) {
    EXPECT_EQ(output.code, 0) << output.err;
    EXPECT_TRUE(output.out.starts_with(words)) << output.out;
    const std::size_t columns =
        bars_of(output.out.substr(0, output.out.find('\n')));
    std::size_t rows = 0;
    std::istringstream in(output.out);
    for (std::string line; std::getline(in, line) && line.starts_with('|');) {
      EXPECT_EQ(bars_of(line), columns) << line;
      ++rows;
    }
    EXPECT_GE(rows, least) << output.out;
  }
  // The bead's brachistochrone to L = 3 H.
  EXPECT_TRUE(says(exported.out, "| 4.510563137 |")) << exported.out;
  EXPECT_EQ(run({"compare", kCylinder, "--markdown", "--json"}).code, 2);
}

}  // namespace
}  // namespace brachisto
