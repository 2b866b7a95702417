// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Exit codes, on which scripts rely.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command.hpp"
#include "app/shell.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::paper_problem;
using testing::run;
using testing::ScratchDirectory;

const std::string kBeadName = "fig06_bead";

TEST(ExitCode, Is0IfSolvedAndVerified) {
  EXPECT_EQ(run({"solve", paper_problem(kBeadName)}).code, 0);
  EXPECT_EQ(run({"validate", paper_problem(kBeadName)}).code, 0);
  EXPECT_EQ(run({"--help"}).code, 0);
  EXPECT_EQ(run({"solve", "--help"}).code, 0);
  EXPECT_EQ(run({"--version"}).code, 0);
}

TEST(ExitCode, Is2ForAWrongCommandLine) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{},
        {"solve"},
        {"slove", "x.yaml"},
        {"solve", paper_problem(kBeadName), "--jsno"},
        {"solve", paper_problem(kBeadName), "another.yaml"},
        {"solve", paper_problem(kBeadName), "--set"},
        {"--frobnicate"}}) {
    const Output output = run(arguments);

    EXPECT_EQ(output.code, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(output.out, "") << ::testing::PrintToString(arguments);
    EXPECT_NE(output.err, "") << ::testing::PrintToString(arguments);
  }
}

TEST(ExitCode, Is3ForABadProblemFile) {
  const ScratchDirectory scratch;
  for (const std::string text :
       {"scene: [", "scene: {bodi: {shape: bead}}", "", "scene: {}",
        "scene: {body: {shape: bead}, finish: {L: 3, H: -1}}"}) {
    const std::string file = scratch.file("bad.yaml", text);
    for (const char* verb : {"solve", "validate"}) {
      const Output output = run({verb, file});

      EXPECT_EQ(output.code, 3) << verb << ": " << text;
      EXPECT_EQ(output.out, "") << verb << ": " << text;
      EXPECT_NE(output.err.find("bad.yaml"), std::string::npos) << output.err;
    }
  }
}

TEST(ExitCode, Is3ForAWrongOverride) {
  for (const std::string override :
       {"scene.body.shpae=bead", "scene.finish.H=0", "scene.finish.H", "=3",
        "scene.finish.L=three"}) {
    const Output output =
        run({"solve", paper_problem(kBeadName), "--set", override});

    EXPECT_EQ(output.code, 3) << override;
    EXPECT_EQ(output.out, "") << override;
    EXPECT_NE(output.err, "") << override;
  }
}

TEST(ExitCode, Is4IfThereIsNoAdmissiblePath) {
  const Output output = run({"solve", paper_problem("fig06_uniform_cylinder"),
                             "--set", "scene.body.radius=2"});

  EXPECT_EQ(output.code, 4);
  EXPECT_NE(output.out.find("inside the"), std::string::npos) << output.out;
}

TEST(ExitCode, Is4IfNotVerified) {
  const Output output =
      run({"solve", paper_problem("fig04_reference_case"), "--set",
           "discretisation={degree: 2, elements: 8, tolerance: 1e-9}"});

  EXPECT_EQ(output.code, 4) << output.err;
  EXPECT_NE(output.out.find("NOT VERIFIED"), std::string::npos) << output.out;
}

TEST(ExitCode, Is4ForThePapersDiscreteSystem) {
  const Output output =
      run({"solve", paper_problem("fig04_reference_case"), "--set",
           "solver={method: fsolve, fsolve: {variant: lifted}}", "--set",
           "discretisation={nodes: 50}"});

  EXPECT_EQ(output.code, 4) << output.err;
  EXPECT_NE(output.out.find("NOT VERIFIED"), std::string::npos) << output.out;
}

TEST(ExitCode, Is5IfTheBodyCouldNotRunOnTheTrack) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file(
      "thrown_off.yaml",
      "scene:\n"
      "  body: {shape: cylinder, radius: 0.2, eta_m: 0.8, k: 0.02}\n"
      "  finish: {L: 0.5, H: 1}\n");

  const Output output = run({"solve", file});

  EXPECT_EQ(output.code, 5) << output.err;
  EXPECT_NE(output.out.find("lift off"), std::string::npos) << output.out;
}

TEST(ExitCode, Is6ForAFileThatCannotBeRead) {
  const ScratchDirectory scratch;
  for (const std::string& file :
       {scratch.path().string() + "/missing.yaml", scratch.path().string()}) {
    const Output output = run({"solve", file});

    EXPECT_EQ(output.code, 6) << file;
    EXPECT_EQ(output.out, "") << file;
    EXPECT_NE(output.err.find(file), std::string::npos) << output.err;
  }
}

TEST(ExitCode, Is6IfNothingCanBeWritten) {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("file", "text");

  EXPECT_EQ(run({"solve", paper_problem(kBeadName), "--out", file}).code, 6);
  EXPECT_EQ(
      run({"solve", paper_problem(kBeadName), "--out", file + "/below"}).code,
      6);
}

TEST(ExitCode, Is7IfALimitIsReached) {
  EXPECT_EQ(run({"solve", paper_problem("fig04_reference_case"), "--set",
                 "discretisation={degree: 1, elements: 100}", "--set",
                 "solver.limits.iterations=1"})
                .code,
            7);
  EXPECT_EQ(run({"solve", paper_problem("fig04_reference_case"), "--set",
                 "solver.limits.seconds=1e-6"})
                .code,
            7);
}

TEST(ExitCode, Is7IfASolveIsTooLargeToBegin) {
  const Output output = run({"solve", paper_problem("fig04_reference_case"),
                             "--json", "--set", "scene.body.radius=1e-9"});

  EXPECT_EQ(output.code, 7);
  EXPECT_NE(output.out.find("\"out_of_memory\""), std::string::npos)
      << output.out;
  EXPECT_NE(output.out.find("Nothing was computed"), std::string::npos)
      << output.out;
}

TEST(ExitCode, Is7WhereverMemoryRunsOut) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "its shadow takes more address space than any limit leaves";
#endif
  const ScratchDirectory scratch;
  const std::string out = (scratch.path() / "out").string();
  const std::string version = testing::run({"--version"}).out;
  int ran_out = 0;
  // Of elements of so high a degree less is foretold than they take.
  for (int megabytes = 60; megabytes <= 240; megabytes += 12) {
    const std::string limit = fmt::format("ulimit -v {}; ", 1024 * megabytes);
    // Where a library complains, or does not load, nothing of ours has begun.
    if (testing::shell(limit + "brachisto --version").out != version) continue;
    const std::string command = fmt::format(
        "{}{} solve {} --json --set discretisation.elements=2000 "
        "--set discretisation.degree=8 "
        "> {} 2> /dev/null",
        limit, BRACHISTO_APP, paper_problem("fig04_reference_case"), out);

    const int status = std::system(command.c_str());

    ASSERT_TRUE(WIFEXITED(status)) << megabytes;
    std::ifstream in(out);
    const json result = json::parse(in, nullptr, false);
    ASSERT_FALSE(result.is_discarded()) << megabytes;
    if (WEXITSTATUS(status) == 0) continue;
    EXPECT_EQ(WEXITSTATUS(status), 7) << megabytes << result["message"];
    EXPECT_EQ(result["status"], "out_of_memory") << megabytes;
    const std::string message = result["message"];
    if (message.find("Nothing was computed") == std::string::npos) ++ran_out;
  }
  EXPECT_GT(ran_out, 0);
}

TEST(ExitCode, IsNotZeroIfTheResultCannotBePrinted) {
  // /dev/full takes nothing: the answer is lost, and a script has to know.
  const std::string command = std::string(BRACHISTO_APP) + " solve " +
                              paper_problem(kBeadName) +
                              " > /dev/full 2> /dev/null";

  EXPECT_NE(std::system(command.c_str()), 0);
}

}  // namespace
}  // namespace brachisto
