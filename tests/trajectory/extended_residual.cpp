// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Two evaluations of the optimality conditions that share no derivative.

#include "trajectory/extended_residual.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "brachisto/nlp/problem.hpp"
#include "derivatives/problems.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

class ExtendedResidualOf : public ::testing::TestWithParam<ProblemCase> {};
INSTANTIATE_TEST_SUITE_P(Problems, ExtendedResidualOf,
                         ::testing::ValuesIn(problem_cases(8, 3)),
                         [](const auto& test) { return test.param.name; });

TEST_P(ExtendedResidualOf, EveryProblemIsTheResidualOfItsOwnFunctions) {
  for (std::uint32_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    RollingTime problem = GetParam().problem();
    const PrimalDual point{random_point(problem, random),
                           random.vector(problem.num_constraints(), -1.0, 1.0)};

    const ExtendedResidual wide = extended_residual(problem, point);
    const nlp::KktResidual plain = nlp::kkt_residual(problem, point);

    // Sums of up to 4 N p products; entries of D below 6 p² times states below
    // 10, others below U w² (1/r + 1) < 3·7·4.
    const double p = problem.mesh().degree;
    const double bound =
        ulps(4.0 * problem.mesh().num_points(), 60.0 * p * p + 100.0);
    EXPECT_NEAR(wide.stationarity, plain.stationarity, bound)
        << "seed " << seed;
    EXPECT_NEAR(wide.defects, plain.infeasibility, bound) << "seed " << seed;
    EXPECT_NEAR(wide.fixed_values, plain.bound_violation, ulps(4.0, 5.0))
        << "seed " << seed;
    EXPECT_EQ(wide.worst_variable, plain.worst_variable) << "seed " << seed;
    EXPECT_EQ(wide.worst_constraint, plain.worst_constraint) << "seed " << seed;
    // Points this random are far from solutions.
    EXPECT_GT(wide.stationarity, 0.1) << "seed " << seed;
    EXPECT_GT(wide.defects, 0.1) << "seed " << seed;
  }
}

TEST_P(ExtendedResidualOf, EveryProblemIsNoNumberIfTheDataAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Random random(1);
  const RollingTime problem = GetParam().problem();
  const PrimalDual point{random_point(problem, random),
                         random.vector(problem.num_constraints(), -1.0, 1.0)};
  PrimalDual bad_x = point;
  bad_x.x[bad_x.x.size() / 2] = nan;
  PrimalDual bad_lambda = point;
  bad_lambda.lambda[point.lambda.size() / 2] = nan;

  const ExtendedResidual of_x = extended_residual(problem, bad_x);
  const ExtendedResidual of_lambda = extended_residual(problem, bad_lambda);

  EXPECT_TRUE(std::isnan(of_x.defects) || std::isnan(of_x.stationarity));
  EXPECT_TRUE(std::isnan(of_lambda.stationarity));
}

}  // namespace
}  // namespace brachisto::testing
