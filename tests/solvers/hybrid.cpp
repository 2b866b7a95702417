// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/square_system.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include "solvers/square_systems.hpp"

namespace brachisto {
namespace {

using namespace testing;

TEST(Hybrid, ReproducesTheExampleOfMinpack) {
  // The norm at which the guide's run ends is 1.2e-8.
  SquareOptions options;
  options.tolerance = 2e-8;

  const SquareResult result =
      solve_by_hybrid(broyden_tridiagonal, broyden_start(), options);

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  for (std::size_t i = 0; i < kBroydenSolution.size(); ++i) {
    EXPECT_NEAR(result.x[i], kBroydenSolution[i], kBroydenPrinted) << i;
  }
  EXPECT_EQ(result.jacobians, 1);
  EXPECT_EQ(result.refused_points, 0);
}

TEST(Hybrid, CountsEveryEvaluation) {
  int calls = 0;
  const SquareResidual counting = [&](auto x, auto F) {
    ++calls;
    return broyden_tridiagonal(x, F);
  };

  const SquareResult result =
      solve_by_hybrid(counting, broyden_start(), SquareOptions{});

  EXPECT_EQ(result.evaluations, calls);
  // The start, nine columns by differences, and one trial point per iteration
  // as long as all of them are taken.
  EXPECT_EQ(result.evaluations, 1 + 9 + result.iterations);
}

TEST(Hybrid, TellsThatItsStepsAreTooSmallForTheTolerance) {
  SquareOptions options;
  options.tolerance = 1e-12;

  const SquareResult result =
      solve_by_hybrid(broyden_tridiagonal, broyden_start(), options);

  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_NE(result.message.find("smaller than √ε"), std::string::npos)
      << result.message;
}

TEST(Hybrid, DoesNotClaimARootThatIsNotThere) {
  const SquareResult result = solve_by_hybrid(rootless, {3.0}, SquareOptions{});

  EXPECT_EQ(result.status, Status::NotConverged);
  EXPECT_GE(result.residual, 1.0);
  EXPECT_NE(result.message.find("progress"), std::string::npos)
      << result.message;
}

TEST(Hybrid, TellsThatTheStartIsNotDefined) {
  const SquareResult result =
      solve_by_hybrid(logarithm, {-1.0}, SquareOptions{});

  EXPECT_EQ(result.status, Status::NotEvaluable);
  EXPECT_EQ(result.evaluations, 1);
  EXPECT_EQ(result.first_refused, std::vector<double>{-1.0});
  EXPECT_NE(result.message.find("not defined at the start"), std::string::npos)
      << result.message;
}

TEST(Hybrid, StopsAtItsLimits) {
  SquareOptions few;
  few.max_iterations = 2;
  SquareOptions late;
  late.stop = StopCondition(0.0, nullptr);
  const std::atomic<int> signal{15};
  SquareOptions interrupted;
  interrupted.stop = StopCondition(1e3, &signal);

  const auto status = [](const SquareOptions& options) {
    return solve_by_hybrid(broyden_tridiagonal, broyden_start(), options)
        .status;
  };

  EXPECT_EQ(status(few), Status::IterationLimit);
  EXPECT_EQ(status(late), Status::TimeLimit);
  EXPECT_EQ(status(interrupted), Status::Interrupted);
}

}  // namespace
}  // namespace brachisto
