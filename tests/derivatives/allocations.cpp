// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <new>

#include "derivatives/counting_new.hpp"
#include "derivatives/problems.hpp"
#include "solvers/chain_matrix.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

/// How often `action` allocates.
template <class Action>
long allocations(Action&& action) {
  const long before = num_allocations();
  action();
  return num_allocations() - before;
}

TEST(Allocations, AreCounted) {
  EXPECT_EQ(allocations([] { ::operator delete(::operator new(24)); }), 1);
}

class Evaluations : public ::testing::TestWithParam<ProblemCase> {};

TEST_P(Evaluations, AllocateNothing) {
  RollingTime problem = GetParam().problem();
  Random random(1);
  const std::vector<double> x = random_point(problem, random);
  const std::vector<double> other = random_point(problem, random);
  const std::vector<double> lambda =
      random.vector(problem.num_constraints(), -1.0, 1.0);
  std::vector<double> grad_f(x.size()), g(lambda.size()),
      jac_g(problem.jac_g_pattern().num_entries()),
      hess_lag(problem.hess_lag_pattern().num_entries());
  bool evaluable = false;
  double f = 0.0;

  EXPECT_EQ(allocations([&] { evaluable = problem.set_point(x); }), 0);
  ASSERT_TRUE(evaluable);
  EXPECT_EQ(allocations([&] { evaluable = problem.set_point(other); }), 0);
  EXPECT_EQ(allocations([&] { f = problem.eval_f(); }), 0);
  EXPECT_EQ(allocations([&] { problem.eval_grad_f(grad_f); }), 0);
  EXPECT_EQ(allocations([&] { problem.eval_g(g); }), 0);
  EXPECT_EQ(allocations([&] { problem.eval_jac_g(jac_g); }), 0);
  EXPECT_EQ(allocations([&] { problem.eval_hess_lag(1.0, lambda, hess_lag); }),
            0);
  EXPECT_GT(f, 0.0);
}

TEST_P(Evaluations, AllocateNothingToRefuseAPoint) {
  RollingTime problem = GetParam().problem();
  Random random(1);
  std::vector<double> x = random_point(problem, random);
  x.back() = -1.0;
  bool evaluable = true;

  EXPECT_EQ(allocations([&] { evaluable = problem.set_point(x); }), 0);

  EXPECT_FALSE(evaluable);
}

TEST(Allocations, OfTheChainGrowInProportionToItsLength) {
  const auto bytes = [](int links) {
    const ChainMatrix matrix = random_saddle(1, links, 50, 4, 1);
    const double before = allocated_bytes();
    const auto ldlt = matrix.analysed();
    EXPECT_TRUE(matrix.factorise(*ldlt));
    return allocated_bytes() - before;
  };

  // Up to the rounding of batches and of growing arrays.
  EXPECT_LE(bytes(32), 2.5 * bytes(16));
}

INSTANTIATE_TEST_SUITE_P(Problems, Evaluations,
                         ::testing::ValuesIn(problem_cases(8, 3)),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto::testing
