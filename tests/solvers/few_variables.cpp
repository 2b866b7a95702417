// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/few_variables.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto::testing {
namespace {

constexpr double kStep = 1e-3;
/// Steps end below this, and each error is less than a hundredth of the last.
constexpr double kAtRest = 1e-9;
/// Of central differences of gradients whose third derivatives are below 10.
constexpr double kOfHessian = 10.0 * kStep * kStep;

/// min (x − 2)² + (y + 1)² + x y/2, x ≤ 1, x + y ≥ −1, of whose second
/// derivatives nothing is told. x = 1 holds and 2 (y + 1) + x/2 = 0: y = −5/4.
class NearestPointWithBound final : public nlp::Problem {
 public:
  explicit NearestPointWithBound(double least_y = -10.0,
                                 double least_sum = -1.0)
      : ranges_{{{-10.0, 1.0}, {least_y, 10.0}}},
        row_ranges_{{{least_sum, 10.0}}} {}

  [[nodiscard]] int num_variables() const override { return 2; }
  [[nodiscard]] int num_constraints() const override { return 1; }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return ranges_[at(index)];
  }
  [[nodiscard]] nlp::Range constraint_range(int index) const override {
    return row_ranges_[at(index)];
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return pattern_;
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return none_;
  }
  [[nodiscard]] std::string variable_name(int) const override { return "x"; }
  [[nodiscard]] std::string constraint_name(int) const override { return "g"; }
  [[nodiscard]] std::string refusal() const override { return "x > 1"; }

 private:
  bool do_set_point(std::span<const double> x) override {
    x_ = {x[0], x[1]};
    return x[0] <= 1.0;  // as where there is no body
  }
  [[nodiscard]] double do_eval_f() const override {
    const auto [x, y] = x_;
    return (x - 2.0) * (x - 2.0) + (y + 1.0) * (y + 1.0) + 0.5 * x * y;
  }
  void do_eval_grad_f(std::span<double> out) const override {
    const auto [x, y] = x_;
    out[0] = 2.0 * (x - 2.0) + 0.5 * y;
    out[1] = 2.0 * (y + 1.0) + 0.5 * x;
  }
  void do_eval_g(std::span<double> out) const override {
    out[0] = x_[0] + x_[1];
  }
  void do_eval_jac_g(std::span<double> out) const override {
    out[0] = out[1] = 1.0;
  }
  void do_eval_hess_lag(double, std::span<const double>,
                        std::span<double>) const override {}

  std::array<double, 2> x_{};
  std::array<nlp::Range, 2> ranges_;
  std::array<nlp::Range, 1> row_ranges_;
  nlp::SparsityPattern pattern_{{0, 0}, {0, 1}}, none_;
};

TEST(FewVariables, HasTheDigitsAndTheCurvaturesOfAQuadraticProblem) {
  NearestPoint problem;

  const FewVariablesPoint found =
      refine_few_variables(problem, {{2.1, 1.8, 2.2}, {-3.9}}, kStep);

  ASSERT_TRUE(found.converged);
  for (const double x : found.point.x) EXPECT_NEAR(x, 2.0, kAtRest);
  EXPECT_NEAR(found.point.lambda[0], -4.0, kAtRest);
  // 2 I on the plane Σ x_i = 6.
  ASSERT_EQ(found.curvatures.size(), 2U);
  for (const double value : found.curvatures) {
    EXPECT_NEAR(value, 2.0, kOfHessian);
  }
}

TEST(FewVariables, FollowsACurvedConstraint) {
  HockSchittkowski7 problem;

  const FewVariablesPoint found =
      refine_few_variables(problem, {{0.01, 1.72}, {0.3}}, kStep);

  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.x[0], 0.0, kAtRest);
  EXPECT_NEAR(found.point.x[1], HockSchittkowski7::kSolution, kAtRest);
  EXPECT_NEAR(found.point.lambda[0], HockSchittkowski7::kMultiplier, kAtRest);
  // Along x₀: 2 + 4 λ at the solution; it was taken a hundredth beside it.
  ASSERT_EQ(found.curvatures.size(), 1U);
  EXPECT_NEAR(found.curvatures[0], 2.0 + 4.0 * HockSchittkowski7::kMultiplier,
              0.1);
}

TEST(FewVariables, HoldsWhatLeansOnABoundAndTellsItsMultiplier) {
  NearestPointWithBound problem;
  // What an interior-point method leaves: products of 1e-8.
  const PrimalDual start{
      {1.0 - 4e-9, -1.25 + 1e-4}, {-1e-8}, {0.0, 0.0}, {2.6, 0.0}};

  const FewVariablesPoint found = refine_few_variables(problem, start, kStep);

  ASSERT_TRUE(found.converged);
  EXPECT_EQ(found.point.x[0], 1.0);
  EXPECT_NEAR(found.point.x[1], -1.25, kAtRest);
  // −∂f/∂x = 2 − y/2.
  EXPECT_NEAR(found.point.z_upper[0], 2.625, kAtRest);
  EXPECT_EQ(found.point.lambda[0], 0.0) << "the row does not hold";
  ASSERT_EQ(found.curvatures.size(), 1U);
  EXPECT_NEAR(found.curvatures[0], 2.0, kOfHessian);
}

TEST(FewVariables, MayBeHeldInEveryDirection) {
  NearestPointWithBound problem(0.0);
  const PrimalDual start{{1.0, 1e-9}, {0.0}, {0.0, 2.5}, {2.0, 0.0}};

  const FewVariablesPoint found = refine_few_variables(problem, start, kStep);

  ASSERT_TRUE(found.converged);
  EXPECT_EQ(found.point.x, (std::vector{1.0, 0.0}));
  EXPECT_NEAR(found.point.z_upper[0], 2.0, kAtRest);
  EXPECT_NEAR(found.point.z_lower[1], 2.5, kAtRest);
  EXPECT_TRUE(found.curvatures.empty());
}

TEST(FewVariables, MayBeHeldInEveryDirectionByARowBesides) {
  NearestPointWithBound problem(0.0, 1.0);
  const PrimalDual start{{1.0, 0.0}, {-1e-9}, {0.0, 2.5}, {2.0, 0.0}};

  const FewVariablesPoint found = refine_few_variables(problem, start, kStep);

  EXPECT_EQ(found.point.x, (std::vector{1.0, 0.0}));
  EXPECT_TRUE(found.curvatures.empty());
}

TEST(FewVariables, LetsGoOfABoundThatTheMinimumOnlyLiesNextTo) {
  // y = −1.25 is allowed; 1e-4 beside its bound a multiplier of 0.1 says that
  // the bound holds.
  NearestPointWithBound problem(-1.26);
  const PrimalDual start{{1.0, -1.26 + 1e-4}, {0.0}, {0.0, 0.1}, {2.6, 0.0}};

  const FewVariablesPoint found = refine_few_variables(problem, start, kStep);

  ASSERT_TRUE(found.converged);
  EXPECT_NEAR(found.point.x[1], -1.25, kAtRest);
  EXPECT_EQ(found.point.z_lower[1], 0.0);
  EXPECT_NEAR(found.point.z_upper[0], 2.625, kAtRest);
  EXPECT_EQ(found.curvatures.size(), 1U);
}

TEST(FewVariables, DoesNotTakeAMaximumForABoundMinimum) {
  NearestPointWithBound problem;
  // Held at x ≤ 1 with the wrong sign it would be a bound that pulls.
  const PrimalDual start{{-10.0, 1.5}, {0.0}, {1.0, 0.0}, {0.0, 0.0}};

  EXPECT_FALSE(refine_few_variables(problem, start, kStep).converged);
}

TEST(Ipopt, BuildsUpAHessianThatNobodyKnows) {
  NearestPointWithBound problem;
  IpoptOptions options;
  options.tolerance = 1e-8;

  const SolverResult found =
      solve_with_ipopt(problem, {{0.0, 0.0}, {}}, options);

  ASSERT_EQ(found.status, Status::Solved) << found.message;
  // The bound is approached as the product with its multiplier falls.
  EXPECT_NEAR(found.point.x[0], 1.0, options.tolerance);
  EXPECT_NEAR(found.point.x[1], -1.25, options.tolerance);
}

}  // namespace
}  // namespace brachisto::testing
