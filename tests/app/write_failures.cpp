// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What cannot be written is told with exit code 6, and nothing half written
// stays: not on a full disk, not above the size that the shell allows a file.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "app/command.hpp"
#include "app/sweep_command.hpp"
#include "app/tiny_disk.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;
using testing::small_sweep;
using testing::sweep;
using testing::table_of;
using testing::TinyDisk;

/// Runs a command that may write no file longer than some units of 512 bytes;
/// its messages go to a pipe.
int code_with_limit(int units, const std::string& arguments) {
  const int status = std::system(
      ("(ulimit -f " + std::to_string(units) + "; '" BRACHISTO_APP "' " +
       arguments +
       "; echo $? >&3) 3>&1 2>&1 | tail -n 1 | (read code; exit $code)")
          .c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool is_empty(const ScratchDirectory& scratch, const std::string& but) {
  for (const auto& entry : fs::directory_iterator(scratch.path())) {
    if (entry.path().filename() != but) return false;
  }
  return true;
}

TEST(FileSizeLimit, LeavesNothingOfASolve) {
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "a" / "b").string();
  for (const int units : {0, 1, 16}) {
    EXPECT_EQ(code_with_limit(units, "solve '" + paper_problem("fig06_bead") +
                                         "' --quiet --out '" + out + "'"),
              6)
        << units;
    EXPECT_TRUE(fs::is_empty(scratch.path())) << units;
  }
}

TEST(FileSizeLimit, LeavesNoStoreWithoutResults) {
  const ScratchDirectory scratch;
  const std::string arguments = "sweep '" + small_sweep(scratch) +
                                "' --quiet --resume --out '" +
                                (scratch.path() / "out").string() + "'";
  for (const int units : {0, 1, 8, 16, 32, 40, 48}) {
    EXPECT_EQ(code_with_limit(units, arguments), 6) << units;
    EXPECT_TRUE(is_empty(scratch, "sweep.yaml")) << units;
  }
}

TEST(FileSizeLimit, KeepsTheResultsOfASweep) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "calm").code, 0);
  const std::string out = (scratch.path() / "out").string();
  EXPECT_EQ(code_with_limit(160, "sweep '" + small_sweep(scratch) +
                                     "' --quiet --out '" + out + "'"),
            6);
  const Output some = run({"export", out, "--csv"});
  EXPECT_EQ(some.code, 0) << some.err;
  EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 1);

  EXPECT_EQ(sweep(scratch, "out", {"--resume"}).code, 0);
  EXPECT_EQ(table_of(scratch, "out"), table_of(scratch, "calm"));
}

TEST(FileSizeLimit, LeavesNothingOfWhatIsMadeOfASweep) {
  const ScratchDirectory scratch;
  ASSERT_EQ(sweep(scratch, "out").code, 0);
  const std::string out = (scratch.path() / "out").string();
  for (const int units : {1, 16, 48}) {
    EXPECT_EQ(code_with_limit(units, "report '" + out + "' --quiet"), 6);
    EXPECT_EQ(std::distance(fs::directory_iterator(out), {}), 1) << units;
    EXPECT_EQ(code_with_limit(
                  units, "merge '" + out + "' --quiet --out '" + out + "2'"),
              6);
    EXPECT_FALSE(fs::exists(out + "2")) << units;
    EXPECT_EQ(code_with_limit(units,
                              "export '" + out + "' --csv > '" + out + ".csv'"),
              units < 30 ? 6 : 0);
  }
}

TEST(FullDisk, LeavesNothing) {
  const ScratchDirectory scratch, elsewhere;
  ASSERT_EQ(sweep(elsewhere, "sweep").code, 0);
  const std::string part = (elsewhere.path() / "sweep").string();
  const TinyDisk disk(scratch.path(), "40k");
  if (!disk) GTEST_SKIP() << "no file system can be mounted here";

  const std::string out = (scratch.path() / "out").string();
  const Output solved =
      run({"solve", paper_problem("fig04_reference_case"), "--out", out});
  EXPECT_EQ(solved.code, 6);
  EXPECT_NE(solved.err.find("No space left"), std::string::npos) << solved.err;
  EXPECT_TRUE(fs::is_empty(scratch.path()));
  EXPECT_EQ(run({"merge", part, "--out", out}).code, 6);
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(FullLog, EndsNoSolve) {
  const int status = std::system(("'" BRACHISTO_APP "' solve '" +
                                  paper_problem("fig04_reference_case") +
                                  "' --quiet --verbose 2> /dev/full")
                                     .c_str());
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, 0);
}

}  // namespace
}  // namespace brachisto
