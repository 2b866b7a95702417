// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What stops a run from outside.

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto {
namespace {

using testing::Function;
using testing::HockSchittkowski7;
using testing::kStart;

TEST(IterationLimit, EndsARunThatNeedsMore) {
  HockSchittkowski7 problem;
  for (const int limit : {0, 1, 3}) {
    IpoptOptions options;
    options.max_iterations = limit;

    const SolverResult result = solve_with_ipopt(problem, kStart, options);

    EXPECT_EQ(result.status, Status::IterationLimit) << result.message;
    EXPECT_EQ(result.iterations, limit);
    EXPECT_EQ(result.point.x.size(), 2u);
  }
}

TEST(IterationLimit, DoesNotTouchARunThatNeedsFewer) {
  HockSchittkowski7 problem;
  const int needed = solve_with_ipopt(problem, kStart, {}).iterations;
  IpoptOptions options;
  options.max_iterations = needed;

  const SolverResult result = solve_with_ipopt(problem, kStart, options);

  EXPECT_EQ(result.status, Status::Solved) << result.message;
}

TEST(TimeLimit, EndsARun) {
  HockSchittkowski7 problem;
  IpoptOptions options;
  options.stop = StopCondition(1e-9, nullptr);

  const SolverResult result = solve_with_ipopt(problem, kStart, options);

  EXPECT_EQ(result.status, Status::TimeLimit) << result.message;
  EXPECT_EQ(result.point.x.size(), 2u);
}

TEST(Interrupt, EndsARun) {
  HockSchittkowski7 problem;
  std::atomic<int> flag{0};
  IpoptOptions options;
  options.stop = StopCondition(3600.0, &flag);
  int hessians = 0;
  problem.on_call = [&](Function function) {
    if (function == Function::HessLag && ++hessians == 2) flag = 15;
  };

  const SolverResult result = solve_with_ipopt(problem, kStart, options);

  EXPECT_EQ(result.status, Status::Interrupted) << result.message;
  EXPECT_EQ(hessians, 2);
}

TEST(Interrupt, TakesPrecedenceOverTheClock) {
  HockSchittkowski7 problem;
  const std::atomic<int> flag{2};
  IpoptOptions options;
  options.stop = StopCondition(1e-9, &flag);

  const SolverResult result = solve_with_ipopt(problem, kStart, options);

  EXPECT_EQ(result.status, Status::Interrupted) << result.message;
}

TEST(StopCondition, ByDefaultIsNeverMet) {
  EXPECT_FALSE(StopCondition().met());
}

TEST(StopCondition, AVeryLongTimeIsNotOver) {
  for (const double seconds :
       {1e6, 1e12, 1e300, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(StopCondition(seconds, nullptr).met()) << seconds;
  }
}

TEST(StopCondition, FollowsItsFlag) {
  std::atomic<int> flag{0};
  const StopCondition stop(3600.0, &flag);
  EXPECT_FALSE(stop.met());

  flag = 2;

  EXPECT_TRUE(stop.interrupted());
  EXPECT_TRUE(stop.met());
  EXPECT_FALSE(stop.out_of_time());
}

}  // namespace
}  // namespace brachisto
