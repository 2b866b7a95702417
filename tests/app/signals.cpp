// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ctrl-C and its like end a solve soon, and in order.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using ::testing::AnyOf;
using testing::Output;
using testing::paper_problem;
using testing::Process;
using testing::ScratchDirectory;
using testing::seconds_to_load;

/// What a signalled command left, and how long it worked until it ended [s].
struct Ended {
  Output output;
  double seconds;
};

/// Sends a signal to a solve of 100 001 nodes that has worked for some seconds
/// since it was loaded.
std::optional<Ended> signalled(int signal, double after,
                               const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "solve", paper_problem("fig04_reference_case"), "--set",
      "discretisation={degree: 5, elements: 20000}"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Process process(std::move(arguments));
  process.work(seconds_to_load() + after);
  const std::optional<double> before = process.cpu_seconds();
  process.signal(signal);
  std::optional<Output> output = process.wait();
  if (!output) return std::nullopt;
  const double since = before ? output->cpu_seconds - *before : 0.0;
  return Ended{std::move(*output), since};
}

// Of processor time, and all of it on a quiet machine: on a busy one a process
// waits besides. A solve has begun after the first and takes longer.
constexpr double kSoon = 0.15;
// What is promised.
constexpr double kMostSeconds = 1.0;

TEST(Signals, AnInterruptEndsASolveWith130AndOneDocument) {
  const ScratchDirectory scratch;

  const auto ended =
      signalled(SIGINT, kSoon, {"--json", "--out", scratch.path().string()});

  ASSERT_TRUE(ended) << "it does not end";
  EXPECT_EQ(ended->output.code, 130) << ended->output.err;
  const json result = json::parse(ended->output.out, nullptr, false);
  ASSERT_FALSE(result.is_discarded()) << ended->output.out;
  EXPECT_EQ(result["status"], "interrupted");
  EXPECT_EQ(result["verified"], false);
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "result.json"));
}

TEST(Signals, ATerminationEndsASolveWith143) {
  const auto ended = signalled(SIGTERM, kSoon, {});

  ASSERT_TRUE(ended) << "it does not end";
  EXPECT_EQ(ended->output.code, 143) << ended->output.err;
  EXPECT_NE(ended->output.out.find("interrupted"), std::string::npos)
      << ended->output.out;
}

/// A way to solve, all of whose moments a signal may meet.
class AnyMoment : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Ways, AnyMoment,
                         ::testing::Values("{method: newton_kkt}",
                                           "{method: ipopt}",
                                           "{linear_solver: mumps}"));

TEST_P(AnyMoment, IsFollowedByTheEndWithinASecond) {
  const std::vector<std::string> way{"--json", "--set",
                                     std::string("solver=") + GetParam()};
  for (const double after : {0.05, 0.2, 0.4, 0.7, 1.0, 1.4, 2.0}) {
    const auto ended = signalled(SIGTERM, after, way);

    ASSERT_TRUE(ended) << "it does not end";
    const json result = json::parse(ended->output.out, nullptr, false);
    EXPECT_FALSE(result.is_discarded()) << ended->output.out;
    if (ended->output.code == 0) break;  // it was done before
    EXPECT_EQ(ended->output.code, 143) << ended->output.err;
    EXPECT_EQ(result["status"], "interrupted");
    EXPECT_LT(ended->seconds, kMostSeconds) << after << " s";
  }
}

TEST(Signals, SentTwiceAtOnceStillLeaveADocument) {
  // As coreutils' timeout does, to the process and to its group. Two of one
  // kind may become one; these both wait for the process to go on.
  Process process({"solve", paper_problem("fig04_reference_case"), "--json",
                   "--set", "discretisation={degree: 5, elements: 20000}"});
  process.work(seconds_to_load() + kSoon);
  process.signal(SIGSTOP);
  process.signal(SIGINT);
  process.signal(SIGTERM);
  process.signal(SIGCONT);

  const auto output = process.wait();

  ASSERT_TRUE(output) << "it does not end";
  EXPECT_THAT(output->code, AnyOf(130, 143)) << output->err;
  EXPECT_FALSE(json::parse(output->out, nullptr, false).is_discarded())
      << output->out;
}

TEST(Limits, AreExceededByNoMoreThanASecond) {
  const std::string mesh = "discretisation={degree: 5, elements: 60000}";
  const std::string turns = "scene.body.radius=0.004";
  for (const auto& [way, more] :
       {std::pair{"method: ipopt", mesh}, std::pair{"method: newton_kkt", mesh},
        std::pair{"linear_solver: mumps", mesh},
        std::pair{"method: extremal", turns}}) {
    const Output validated = testing::run(
        {"validate", paper_problem("fig04_reference_case"), "--json", "--set",
         fmt::format("solver={{{}}}", way), "--set", more});
    const double needed = json::parse(validated.out)["forecast"]["seconds"];
    // Foretold to a factor of two; with less than a twentieth it is not begun.
    for (const double share : {0.15, 0.25}) {
      const double seconds = share * needed;
      const std::string solver =
          fmt::format("solver={{{}, limits: {{seconds: {}}}}}", way, seconds);

      const auto output =
          Process({"solve", paper_problem("fig04_reference_case"), "--json",
                   "--set", solver, "--set", more})
              .wait();

      ASSERT_TRUE(output) << "it does not end";
      EXPECT_LT(output->cpu_seconds, seconds + kMostSeconds) << solver;
      EXPECT_EQ(output->code, 7) << solver << output->err;
      const json result = json::parse(output->out, nullptr, false);
      EXPECT_EQ(result["status"], "time_limit") << output->out;
      EXPECT_EQ(result.value("message", "").find("Nothing was computed"),
                std::string::npos)
          << output->out;
    }
  }
}

}  // namespace
}  // namespace brachisto
