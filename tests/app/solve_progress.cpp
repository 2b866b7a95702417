// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/solve_progress.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace brachisto::app {
namespace {

using std::chrono::milliseconds;

struct Watched {
  std::vector<std::string> lines;
  SolveProgress progress{
      [this](const std::string& line) { lines.push_back(line); },
      SolveProgress::Clock::time_point{}};

  void note(int after_ms, const char* phase, const char* text) {
    progress.note(SolveProgress::Clock::time_point(milliseconds(after_ms)),
                  phase, text);
  }
};

TEST(SolveProgress, IsSilentAboutAShortSolve) {
  Watched watched;

  watched.note(10, "continuation", "first");
  watched.note(900, "mesh", "solving");
  watched.note(1900, "certificate", "of 100 nodes");

  EXPECT_TRUE(watched.lines.empty());
}

TEST(SolveProgress, TellsOfEveryPhaseOnceItIsLong) {
  Watched watched;

  watched.note(10, "continuation", "first");
  watched.note(1500, "continuation", "last");
  watched.note(1900, "mesh", "solving");
  watched.note(2500, "mesh", "solved");
  watched.note(2600, "certificate", "of 100 nodes");

  EXPECT_EQ(watched.lines,
            (std::vector<std::string>{"[   2 s] continuation: last",
                                      "[   2 s] mesh: solved",
                                      "[   3 s] certificate: of 100 nodes"}));
}

TEST(SolveProgress, TellsOfAPhaseNowAndThen) {
  Watched watched;

  for (int second = 1; second <= 20; ++second) {
    watched.note(1000 * second, "continuation", std::to_string(second).c_str());
  }

  EXPECT_EQ(watched.lines,
            (std::vector<std::string>{
                "[   5 s] continuation: 5", "[  10 s] continuation: 10",
                "[  15 s] continuation: 15", "[  20 s] continuation: 20"}));
}

}  // namespace
}  // namespace brachisto::app
