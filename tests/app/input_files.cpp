// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What may be given as a file, and standard input.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "app/command.hpp"

namespace brachisto {
namespace {

namespace fs = std::filesystem;
using testing::Output;
using testing::paper_problem;
using testing::Process;
using testing::run;
using testing::ScratchDirectory;

const std::string kUniform = paper_problem("fig06_uniform_cylinder");

TEST(InputFiles, ThatMayNeverEndAreRefusedAtOnce) {
  const ScratchDirectory scratch;
  const std::string pipe = (scratch.path() / "pipe").string();
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string out = (scratch.path() / "out").string();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"solve", pipe},
        {"validate", pipe},
        {"sweep", pipe, "--out", out},
        {"compare", pipe},
        {"work-precision", pipe},
        {"solve", "/dev/zero"},
        {"solve", "/dev/tty0"}}) {
    Process process(arguments);
    const auto output = process.wait();
    ASSERT_TRUE(output) << "it waits";
    EXPECT_EQ(output->code, 6) << arguments[0] << ' ' << output->err;
    EXPECT_NE(output->err.find("expected a problem file"), std::string::npos)
        << output->err;
  }
  EXPECT_FALSE(fs::exists(out));
}

/// Exit code of a command that has a file as its standard input.
int code_with_input(const std::string& arguments, const std::string& input) {
  const int status = std::system(("'" BRACHISTO_APP "' " + arguments + " < '" +
                                  input + "' > /dev/null 2> /dev/null")
                                     .c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(InputFiles, MayBeStandardInput) {
  EXPECT_EQ(code_with_input("solve -", kUniform), 0);
  EXPECT_EQ(code_with_input("solve - --set scene.finish.L=x", kUniform), 3);
  EXPECT_EQ(code_with_input("validate -", kUniform), 0);
  EXPECT_EQ(code_with_input("validate -", "/dev/null"), 3);
  // Processes of their own read the file anew.
  EXPECT_EQ(code_with_input("compare -", kUniform), 6);
  EXPECT_EQ(code_with_input("table -", kUniform), 6);
  const ScratchDirectory scratch;
  const std::string sweep =
      scratch.file("sweep.yaml",
                   "scene: {body: {shape: bead}, finish: {L: 3, H: 1}}\n"
                   "sweep: {scene.finish.L: [1, 2, 3]}\n");
  EXPECT_EQ(code_with_input(
                "sweep - --out " + (scratch.path() / "out").string(), sweep),
            0);
  const std::string design = scratch.file(
      "design.yaml",
      "scene: {body: {shape: cylinder, radius: 1/3, eta_m: 0.3, k: 0.4},\n"
      "  finish: {L: 3, H: 1}}\n"
      "design: {free: [eta_m], starts: 1, bounds: {eta_m: [0.2, 0.4]}}\n"
      "solver: {guess: straight}\n");  // which has no effect on the inner
                                       // solves
  EXPECT_EQ(code_with_input("design -", design), 0);
}

TEST(InputFiles, OfPointsMayChangeWithoutASweepTakingThemForTheSame) {
  const ScratchDirectory scratch;
  const std::string problem =
      scratch.file("p.yaml",
                   "scene:\n"
                   "  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
                   "  finish: {L: 3, H: 1}\n"
                   "  path: {curve: track, shape: points, file: track.csv}\n"
                   "sweep: {scene.body.eta_m: [0, 1/3]}\n");
  const std::string out = (scratch.path() / "out").string();
  (void)scratch.file("track.csv", "x,z\n0,0\n1,0.7\n3,1\n");
  const std::vector<std::string> resume{"sweep", problem, "--out", out,
                                        "--resume"};
  ASSERT_EQ(run(resume).code, 0);
  const std::string before = run({"export", out, "--csv"}).out;
  (void)scratch.file("track.csv", "x,z\n0,0\n1,0.75\n3,1\n");

  const Output changed = run(resume);

  EXPECT_EQ(changed.code, 6);
  EXPECT_NE(changed.err.find("1,0.7 as point 2 from track.csv, which has "
                             "1,0.75 now"),
            std::string::npos)
      << changed.err;
  // The store has what it needs with it.
  fs::remove(scratch.path() / "track.csv");
  EXPECT_EQ(run({"export", out, "--csv"}).out, before);
  EXPECT_EQ(run({"report", out}).code, 0);
  EXPECT_EQ(run({"merge", out, "--out", out + "2"}).code, 0);
  const Output missing = run(resume);
  EXPECT_EQ(missing.code, 6);
  EXPECT_NE(missing.err.find("track.csv: cannot be opened"), std::string::npos)
      << missing.err;
}

}  // namespace
}  // namespace brachisto
