// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Problem files that `brachisto new` writes.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "app/shell.hpp"
#include "report/letters.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using testing::lines_of;
using testing::Output;
using testing::run;
using testing::ScratchDirectory;
using testing::shell;

const std::vector<std::string> kKinds{"case", "limits", "world", "sweep",
                                      "design"};

TEST(New, WritesFilesOfEveryKindThatAreValidAndSolve) {
  const ScratchDirectory scratch;
  for (const std::string& kind : kKinds) {
    // A name that a shell would take for two.
    const std::string name = "my " + kind;
    const Output output =
        shell("brachisto new '" + name + "' --kind " + kind, scratch.path());
    ASSERT_EQ(output.code, 0) << output.out;

    // What it says comes next, as it stands.
    const std::string next = lines_of(output.out).at(1);
    EXPECT_TRUE(next.starts_with("  brachisto ")) << output.out;
    const Output solved =
        shell("brachisto validate --quiet '" + name + ".yaml' &&" + next,
              scratch.path());
    EXPECT_EQ(solved.code, 0) << kind << "\n" << solved.out;
    EXPECT_NE(solved.out.find("verified"), std::string::npos) << solved.out;
  }
}

TEST(New, WantsTheNameOfAFile) {
  const ScratchDirectory scratch;

  const Output output = shell("brachisto new ./", scratch.path());

  EXPECT_EQ(output.code, 2);
  EXPECT_FALSE(std::filesystem::exists(scratch.path() / ".yaml"));
}

TEST(New, StatesBehindHashesWhatIsValidToo) {
  const ScratchDirectory scratch;
  for (const std::string& kind : kKinds) {
    const std::string file = (scratch.path() / kind).string();
    ASSERT_EQ(run({"new", file, "--kind", kind}).code, 0);
    const std::string text = content(file + ".yaml");

    const std::string all =
        std::regex_replace(text, std::regex("\n( *)#([a-z])"), "\n$1$2");

    EXPECT_NE(all, text) << kind;
    const Output output =
        run({"validate", "--quiet", scratch.file("all.yaml", all)});
    EXPECT_EQ(output.code, 0) << kind << "\n" << output.err;
  }
}

TEST(New, BreaksItsCommentsIntoLines) {
  const ScratchDirectory scratch;
  const std::string file = (scratch.path() / "track").string();
  ASSERT_EQ(run({"new", file}).code, 0);

  std::vector<std::string> lines = lines_of(content(file + ".yaml"));

  if (lines.front().find("$schema=") != std::string::npos) {
    lines.erase(lines.begin());
  }
  constexpr std::size_t kLetters = 88;
  for (const std::string& line : lines) {
    EXPECT_LE(report::letters(line), kLetters) << line;
  }
}

TEST(New, TellsEditorsWhereTheSchemaIs) {
  const ScratchDirectory scratch;
  const std::string file = (scratch.path() / "track.yaml").string();
  ASSERT_EQ(shell("brachisto new '" + file + "'").code, 0);

  const std::string line = lines_of(content(file)).front();

  const std::string begin = "# yaml-language-server: $schema=file://";
  ASSERT_TRUE(line.starts_with(begin)) << line;
  EXPECT_TRUE(fs::equivalent(
      line.substr(begin.size()),
      testing::tree().share / "brachisto/schemas/problem.schema.json"));
}

TEST(New, ReplacesAFileOnlyByForce) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("mine.yaml", "my work\n");

  const Output refused = run({"new", file});
  EXPECT_EQ(refused.code, 6);
  EXPECT_NE(refused.err.find("exists; --force replaces it"), std::string::npos)
      << refused.err;
  EXPECT_EQ(content(file), "my work\n");

  EXPECT_EQ(run({"new", file, "--force"}).code, 0);
  EXPECT_NE(content(file).find("mine: one scene"), std::string::npos);
}

TEST(New, MakesDirectoriesAndRefusesUnknownKinds) {
  const ScratchDirectory scratch;
  const fs::path file = scratch.path() / "deep/er/track";
  EXPECT_EQ(run({"new", file.string(), "--quiet"}).out, "");
  EXPECT_TRUE(fs::exists(file.string() + ".yaml"));

  const Output output =
      run({"new", (scratch.path() / "x").string(), "--kind", "wheel"});
  EXPECT_EQ(output.code, 2);
  EXPECT_NE(output.err.find("{case,limits,world,sweep,design}"),
            std::string::npos)
      << output.err;
}

TEST(New, CommentsHoldNoControlCharactersOfTheName) {
  const ScratchDirectory scratch;
  const std::string file = (scratch.path() / "a\nscene: 3").string();

  ASSERT_EQ(run({"new", file}).code, 0);

  EXPECT_EQ(run({"validate", "--quiet", file + ".yaml"}).code, 0);
}

}  // namespace
}  // namespace brachisto
