// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Several threads may solve at once.

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "brachisto/study/solve.hpp"
#include "support/reference_values.hpp"

namespace brachisto {
namespace {

using testing::kReferenceValues;
using testing::ReferenceValue;

struct WayWithThreads {
  const char* name;
  std::variant<Collocation, Shooting, DiscreteSystem> method;
};
void PrintTo(const WayWithThreads& way, std::ostream* out) {
  *out << way.name;
}

class Threads : public ::testing::TestWithParam<WayWithThreads> {};
INSTANTIATE_TEST_SUITE_P(
    Ways, Threads,
    ::testing::Values(
        WayWithThreads{"chain",
                       Collocation{.linear_solver = LinearSolver::Chain}},
        WayWithThreads{"mumps",
                       Collocation{.linear_solver = LinearSolver::Mumps}},
        WayWithThreads{"newton",
                       Collocation{.solver = ProgramSolver::NewtonKkt}},
        WayWithThreads{"extremal", Shooting{}}));

TEST_P(Threads, FindTheRightAnswersAtOnce) {
  constexpr std::size_t kThreads = 4;
  constexpr int kRounds = 4;
  SolveOptions options;
  options.method = GetParam().method;
  std::array<std::vector<std::string>, kThreads> wrong;
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      // Every thread begins with another scene.
      for (int round = 0; round < kRounds; ++round) {
        const std::size_t i = (5 * t + static_cast<std::size_t>(round)) %
                              std::size(kReferenceValues);
        const ReferenceValue& row = kReferenceValues[i];
        const Solution solution = solve(row.scene(), options);
        if (!solution.verified()) {
          wrong[t].push_back(row.name + std::string(": ") + solution.message);
        } else if (!(std::abs(solution.motion()->tau() / row.tau - 1.0) <=
                     2.0 * kDefaultTolerance)) {
          wrong[t].push_back(row.name + std::string(": ") +
                             std::to_string(solution.motion()->tau()));
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();

  for (const auto& lines : wrong) {
    for (const std::string& line : lines) ADD_FAILURE() << line;
  }
}

}  // namespace
}  // namespace brachisto
