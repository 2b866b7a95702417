// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/square_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solvers/square_systems.hpp"

namespace brachisto {
namespace {

using namespace testing;

bool broyden_step(std::span<const double> x, std::span<const double> F,
                  std::span<double> step) {
  const auto n = static_cast<Eigen::Index>(x.size());
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    J(i, i) = 3.0 - 4.0 * x[static_cast<std::size_t>(i)];
    if (i > 0) J(i, i - 1) = -1.0;
    if (i + 1 < n) J(i, i + 1) = -2.0;
  }
  Eigen::Map<Eigen::VectorXd>(step.data(), n) =
      -J.partialPivLu().solve(Eigen::Map<const Eigen::VectorXd>(F.data(), n));
  return true;
}

bool logarithm_step(std::span<const double> x, std::span<const double> F,
                    std::span<double> step) {
  step[0] = -F[0] * x[0];
  return true;
}

bool rootless_step(std::span<const double> x, std::span<const double> F,
                   std::span<double> step) {
  if (x[0] == 0.0) return false;
  step[0] = -F[0] / (2.0 * x[0]);
  return true;
}

TEST(DampedNewton, FindsTheSolutionThatMinpackPrints) {
  SquareOptions options;
  options.tolerance = 1e-12;

  const SquareResult result = solve_by_damped_newton(
      broyden_tridiagonal, broyden_step, broyden_start(), options);

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  for (std::size_t i = 0; i < kBroydenSolution.size(); ++i) {
    EXPECT_NEAR(result.x[i], kBroydenSolution[i], kBroydenPrinted) << i;
  }
  // Undamped, hence quadratic: 1 → 1e-2 → 1e-4 → 1e-8 → 1e-16.
  EXPECT_LE(result.iterations, 5);
  EXPECT_EQ(result.evaluations, 1 + result.iterations);
  EXPECT_EQ(result.jacobians, result.iterations);
}

TEST(DampedNewton, ShortensStepsIntoTheUndefined) {
  SquareOptions options;
  options.tolerance = 1e-12;

  const SquareResult result =
      solve_by_damped_newton(logarithm, logarithm_step, {10.0}, options);

  ASSERT_EQ(result.status, Status::Solved) << result.message;
  EXPECT_NEAR(result.x[0], 1.0, options.tolerance);
  EXPECT_GT(result.refused_points, 0);
  // The full step to 10 − 10 ln 10.
  ASSERT_EQ(result.first_refused.size(), 1u);
  EXPECT_DOUBLE_EQ(result.first_refused[0], 10.0 - 10.0 * std::log(10.0));
}

TEST(DampedNewton, TellsWhereItIsStuck) {
  const auto solve = [](double start) {
    return solve_by_damped_newton(rootless, rootless_step, {start},
                                  SquareOptions{});
  };

  const SquareResult singular = solve(0.0);
  const SquareResult stuck = solve(3.0);

  EXPECT_EQ(singular.status, Status::NotConverged);
  EXPECT_NE(singular.message.find("singular"), std::string::npos)
      << singular.message;
  EXPECT_NE(stuck.status, Status::Solved);
  EXPECT_GE(stuck.residual, 1.0);
}

TEST(DampedNewton, StopsAtItsLimits) {
  SquareOptions few;
  few.max_iterations = 1;
  SquareOptions late;
  late.stop = StopCondition(0.0, nullptr);

  const auto status = [](const SquareOptions& options) {
    return solve_by_damped_newton(broyden_tridiagonal, broyden_step,
                                  broyden_start(), options)
        .status;
  };

  EXPECT_EQ(status(few), Status::IterationLimit);
  EXPECT_EQ(status(late), Status::TimeLimit);
}

}  // namespace
}  // namespace brachisto
