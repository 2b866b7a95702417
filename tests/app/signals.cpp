// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ctrl-C and its like end a solve soon, and in order.

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/command.hpp"

namespace brachisto {
namespace {

using nlohmann::json;
using testing::Output;
using testing::paper_problem;
using testing::Process;
using testing::ScratchDirectory;

/// A solve of half a minute, sent a signal once it is under way.
std::optional<Output> signalled(int signal,
                                const std::vector<std::string>& more) {
  std::vector<std::string> arguments{
      "solve", paper_problem("fig04_reference_case"), "--set",
      "discretisation={degree: 5, elements: 20000}"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  Process process(std::move(arguments));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  process.signal(signal);
  // The signal is noticed between iterations, of which each takes about a
  // second on 100 001 nodes, and the first, with the analysis, about three.
  return process.wait(std::chrono::seconds(10));
}

TEST(Signals, AnInterruptEndsASolveWith130AndOneDocument) {
  const ScratchDirectory scratch;

  const auto output =
      signalled(SIGINT, {"--json", "--out", scratch.path().string()});

  ASSERT_TRUE(output) << "it does not end";
  EXPECT_EQ(output->code, 130) << output->err;
  const json result = json::parse(output->out, nullptr, false);
  ASSERT_FALSE(result.is_discarded()) << output->out;
  EXPECT_EQ(result["status"], "interrupted");
  EXPECT_EQ(result["verified"], false);
  EXPECT_TRUE(std::filesystem::exists(scratch.path() / "result.json"));
}

TEST(Signals, ATerminationEndsASolveWith143) {
  const auto output = signalled(SIGTERM, {});

  ASSERT_TRUE(output) << "it does not end";
  EXPECT_EQ(output->code, 143) << output->err;
  EXPECT_NE(output->out.find("interrupted"), std::string::npos) << output->out;
}

}  // namespace
}  // namespace brachisto
