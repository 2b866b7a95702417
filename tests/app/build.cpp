// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// --track-svg, --track-dxf and how the track is built.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/tiny_disk.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::content;
using ::testing::HasSubstr;
using testing::names;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;
using testing::TinyDisk;

const std::string kBuilt = BRACHISTO_PROBLEMS_DIR "/build/cylinder.yaml";

Output built(const fs::path& directory, std::vector<std::string> flags = {},
             const std::string& problem = kBuilt) {
  flags.insert(flags.begin(), {"solve", problem, "--quiet", "--track-svg",
                               directory.string()});
  return run(flags);
}

const std::set<std::string> kSheets{"assembly-01.svg", "assembly-02.svg",
                                    "sheet-01.svg"};

TEST(Build, WritesSheetsAndAnAssembly) {
  const ScratchDirectory scratch;
  const fs::path svg = scratch.path() / "a b" / "c'\"<\n", dxf = svg / "dxf";

  const Output output = built(svg, {"--track-dxf", dxf.string()});

  EXPECT_EQ(output.code, 0) << output.err;
  EXPECT_EQ(names(dxf).size(), kSheets.size());
  fs::remove_all(dxf);
  EXPECT_EQ(names(svg), kSheets);
}

TEST(Build, RefusesWhatIsNoSizeBeforeAnythingIsWritten) {
  struct Refused {
    std::vector<std::string> flags;
    const char* words;
  };
  const Refused all[] = {
      {{"--scale", "0:5"}, "\"0:5\" was read; expected two numbers from 0.001"},
      {{"--scale", "1:0"}, "\"1:0\" was read"},
      {{"--scale", "0"}, "\"0\" was read"},
      {{"--scale", "1:5x"}, "\"1:5x\" was read"},
      {{"--sheet", "600"}, "\"600\" was read; expected two numbers from 150"},
      {{"--sheet", "-600x400"}, "\"-600x400\" was read"},
      {{"--sheet", "nanx400"}, "\"nanx400\" was read"},
      {{"--strip=-40"}, "\"-40\" was read; expected a number of millimetres"},
      {{"--hole=-6"}, "\"-6\" was read"},
      {{"--thickness", "0"}, "\"0\" was read"},
      {{"--rails=-15"}, "\"-15\" was read"},
      {{"--hole", "nan"}, "\"nan\" was read"},
      {{"--hole", "15"}, "a strip of 40 mm has no room for holes of 15 mm"},
      {{"--scale", "10:1"}, "a body of 800 mm does not fit on a sheet of 600"},
      {{"--scale", "1:1000"}, "a track of 1.374 mm is too short for its holes"},
      {{"--sheet", "150x150", "--strip", "60"},
       "longer ones do not fit on a sheet"}};
  for (const Refused& one : all) {
    const ScratchDirectory scratch;
    std::vector<std::string> flags = one.flags;
    flags.insert(flags.end(), {"--out", (scratch.path() / "results").string()});

    const Output output = built(scratch.path() / "sheets", flags);

    EXPECT_EQ(output.code, 2) << one.words;
    EXPECT_THAT(output.err, HasSubstr(one.words));
    EXPECT_TRUE(output.out.empty());
    EXPECT_TRUE(fs::is_empty(scratch.path())) << one.words;
  }
}

TEST(Build, FlagsAreRefusedWithoutADirectoryForTheSheets) {
  const std::vector<std::string> all[] = {
      {"--scale", "1:5"},     {"--strip", "20"}, {"--thickness", "4"},
      {"--sheet", "600x400"}, {"--hole", "4"},   {"--rails", "15"}};
  for (const std::vector<std::string>& flags : all) {
    const Output output = run({"solve", kBuilt, flags[0], flags[1]});
    EXPECT_EQ(output.code, 2) << flags[0];
    EXPECT_THAT(output.err, HasSubstr("brachisto solve: " + flags[0] +
                                      " requires --track-svg or --track-dxf"));
    EXPECT_TRUE(output.out.empty());
  }
  // A flag that nobody knows comes first.
  EXPECT_THAT(run({"solve", kBuilt, "--rails", "15", "--strp", "3"}).err,
              HasSubstr("--strp is not a flag of solve"));
}

TEST(Build, IsNothingForATrackThatCannotBeRolledOn) {
  const ScratchDirectory scratch;
  const Output output = built(scratch.path() / "sheets", {"--scale", "1:5"},
                              BRACHISTO_PROBLEMS_DIR "/hard/r_0.02.yaml");
  EXPECT_EQ(output.code, 5) << output.err;
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(Build, ReplacesAnEarlierTrackOnlyIfAskedTo) {
  const ScratchDirectory scratch;
  ASSERT_EQ(built(scratch.path(), {"--rails", "20"}).code, 0);
  const auto before = names(scratch.path());
  ASSERT_GT(before.size(), kSheets.size());
  std::ofstream(scratch.path() / "sheet-music.svg") << "mine";

  const Output refused = built(scratch.path());
  EXPECT_EQ(refused.code, 6);
  EXPECT_THAT(refused.err, HasSubstr("exists; --force replaces it"));
  EXPECT_EQ(names(scratch.path()).size(), before.size() + 1);

  EXPECT_EQ(built(scratch.path(), {"--force"}).code, 0);
  auto expected = kSheets;
  expected.insert("sheet-music.svg");
  EXPECT_EQ(names(scratch.path()), expected);
}

TEST(Build, WritesThroughALinkedDirectoryAndNotThroughALinkedFile) {
  const ScratchDirectory scratch;
  const fs::path real = scratch.path() / "real", link = scratch.path() / "link";
  const fs::path other = scratch.path() / "other";
  fs::create_directory(real);
  fs::create_directory_symlink(real, link);
  std::ofstream(other) << "mine";
  fs::create_symlink(other, real / "sheet-01.svg");

  EXPECT_EQ(built(link).code, 6);
  EXPECT_EQ(built(link, {"--force"}).code, 0);

  EXPECT_EQ(names(real), kSheets);
  EXPECT_FALSE(fs::is_symlink(real / "sheet-01.svg"));
  EXPECT_EQ(content(other), "mine");
}

TEST(Build, TellsWhereItCannotBeWritten) {
  const ScratchDirectory scratch;
  std::ofstream(scratch.path() / "file") << "mine";
  const Output output = built(scratch.path() / "file" / "sheets");
  EXPECT_EQ(output.code, 6);
  EXPECT_THAT(output.err, HasSubstr("exists and is not a directory"));
  // Nobody may write there, not even who may write anywhere.
  EXPECT_EQ(built("/proc/sheets").code, 6);
}

TEST(Build, LeavesNothingOnAFullDisk) {
  const ScratchDirectory scratch;
  const TinyDisk disk(scratch.path(), "16k");
  if (!disk) GTEST_SKIP() << "mounting a small disk is not allowed";
  const Output output = built(scratch.path() / "sheets");
  EXPECT_EQ(output.code, 6);
  EXPECT_THAT(output.err, HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

}  // namespace
}  // namespace brachisto
