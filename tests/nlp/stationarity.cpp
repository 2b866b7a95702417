// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "nlp/stationarity.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "nlp/tiny_problem.hpp"

namespace brachisto {
namespace {

/// At (2, 1, 2): 2 x_0 + λ_0 + x_1 λ_1 = 0, 2 x_1 + λ_0 + x_0 λ_1 = 0 and
/// 5 − λ_0 = 0.
TEST(MakeStationary, SolvesForTheMultipliersThatAreNamedAndKeepsTheOthers) {
  testing::TinyProblem problem;
  PrimalDual point{{2.0, 1.0, 2.0}, {7.0, 1.0}};
  ASSERT_TRUE(problem.set_point(point.x));

  nlp::make_stationary(problem, {1, 0}, {0, 1}, point);
  EXPECT_EQ(point.lambda, (std::vector<double>{-6.0, 2.0}));

  nlp::make_stationary(problem, {2}, {0}, point);
  EXPECT_EQ(point.lambda, (std::vector<double>{5.0, 2.0}));

  nlp::make_stationary(problem, {0}, {0}, point);
  EXPECT_EQ(point.lambda, (std::vector<double>{-6.0, 2.0}));
}

}  // namespace
}  // namespace brachisto
