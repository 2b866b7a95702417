// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ipopt and MUMPS keep state in variables of the process: one run at a time.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/inertia.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto {
namespace {

using testing::Function;
using testing::HockSchittkowski7;
using testing::kStart;

/// A run of Ipopt in another thread that lasts until it is let go.
class LongRun {
 public:
  LongRun() : thread_([this] { run(); }) {
    while (!inside_) std::this_thread::yield();
  }
  ~LongRun() { finish(); }
  LongRun(const LongRun&) = delete;
  LongRun& operator=(const LongRun&) = delete;

  Status finish() {
    go_on_ = true;
    if (thread_.joinable()) thread_.join();
    return status_;
  }

 private:
  void run() {
    HockSchittkowski7 problem;
    problem.on_call = [this](Function) {
      inside_ = true;
      while (!go_on_) std::this_thread::yield();
    };
    status_ = solve_with_ipopt(problem, kStart, {}).status;
  }

  std::atomic<bool> inside_{false}, go_on_{false};
  Status status_ = Status::InternalError;
  std::thread thread_;
};

TEST(IpoptInThreads, TakesTurns) {
  LongRun other;
  std::atomic<bool> evaluated{false};
  HockSchittkowski7 problem;
  problem.on_call = [&](Function) { evaluated = true; };
  SolverResult mine;
  std::thread thread([&] { mine = solve_with_ipopt(problem, kStart, {}); });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));

  EXPECT_FALSE(evaluated);
  EXPECT_EQ(other.finish(), Status::Solved);
  thread.join();
  EXPECT_EQ(mine.status, Status::Solved) << mine.message;
}

TEST(IpoptInThreads, WaitsNoLongerThanItsLimit) {
  LongRun other;
  HockSchittkowski7 problem;
  IpoptOptions options;
  options.stop = StopCondition(0.1, nullptr);

  const SolverResult mine = solve_with_ipopt(problem, kStart, options);

  EXPECT_EQ(mine.status, Status::TimeLimit) << mine.message;
  EXPECT_EQ(mine.point.x, kStart.x);
  EXPECT_EQ(other.finish(), Status::Solved);
}

TEST(IpoptInThreads, WaitsNoLongerThanAConditionInForce) {
  LongRun other;
  HockSchittkowski7 problem;
  const StopScope scope(StopCondition(0.1, nullptr));

  EXPECT_THROW(static_cast<void>(solve_with_ipopt(problem, kStart, {})),
               Stopped);
}

TEST(IpoptInThreads, LeavesItsPlaceIfItThrows) {
  HockSchittkowski7 problem;
  problem.on_call = [](Function) { throw 42; };
  EXPECT_THROW(static_cast<void>(solve_with_ipopt(problem, kStart, {})), int);
  problem.on_call = [](Function) {};

  EXPECT_EQ(solve_with_ipopt(problem, kStart, {}).status, Status::Solved);
}

}  // namespace
}  // namespace brachisto
