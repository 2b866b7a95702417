// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Values at a distance h against models of first and second order: what a
// correct derivative leaves falls as h² and h³, whatever its size.

#include <gtest/gtest.h>

#include "derivatives/problems.hpp"
#include "derivatives/taylor_remainders.hpp"
#include "support/observed_order.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

class Taylor : public ::testing::TestWithParam<ProblemCase> {
 protected:
  /// \param start_speed  size of w in the first element; its changes are as
  ///                     small, for w stays positive
  static TaylorRemainders remainders(std::uint32_t first_seed,
                                     double start_speed) {
    constexpr std::uint32_t kSeeds = 10;
    TaylorRemainders total;
    for (std::uint32_t seed = first_seed; seed < first_seed + kSeeds; ++seed) {
      Random random(seed);
      RollingTime problem = GetParam().problem();
      const std::vector<double> x = random_point(problem, random, start_speed);
      const std::vector<double> lambda =
          random.vector(problem.num_constraints(), -1.0, 1.0);
      std::vector<double> direction =
          random.vector(problem.num_variables(), -1.0, 1.0);
      for (int n = 0; n <= problem.mesh().degree; ++n) {
        direction[static_cast<std::size_t>(
            problem.layout().state(n, StateComponent::W))] *= start_speed;
      }
      total.add(problem, x, lambda, direction);
    }
    return total;
  }
};

void expect_orders(const TaylorRemainders& remainder, int first_seed) {
  EXPECT_NEAR(observed_order(kSteps, remainder.g()), 2.0, kSlack)
      << "seeds from " << first_seed << ", remainders "
      << ::testing::PrintToString(remainder.g());
  EXPECT_NEAR(observed_order(kSteps, remainder.lagrangian()), 3.0, kSlack)
      << "seeds from " << first_seed << ", remainders "
      << ::testing::PrintToString(remainder.lagrangian());
}

TEST_P(Taylor, RemaindersFallAsSquareAndCubeAtRandomPoints) {
  expect_orders(remainders(1, 1.0), 1);
}

TEST_P(Taylor, RemaindersFallAsSquareAndCubeNextToTheStart) {
  expect_orders(remainders(101, 1e-6), 101);
}

INSTANTIATE_TEST_SUITE_P(Problems, Taylor,
                         ::testing::ValuesIn(problem_cases(8, 5)),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto::testing
