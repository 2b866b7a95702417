// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Ipopt's own derivative checker, once.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brachisto/solvers/program_solvers.hpp"
#include "derivatives/problems.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {
namespace {

/// What Ipopt says of the derivatives at a random point.
std::string checker_log(RollingTime& problem, nlp::Problem& checked) {
  Random random(1);
  const PrimalDual start{random_point(problem, random), {}};
  IpoptOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;
  return solve_with_ipopt(checked, start, options).log;
}

class IpoptChecker : public ::testing::TestWithParam<ProblemCase> {};

TEST_P(IpoptChecker, FindsNoErrorUpToSecondOrder) {
  RollingTime problem = GetParam().problem();

  const std::string log = checker_log(problem, problem);

  EXPECT_THAT(log, ::testing::HasSubstr(
                       "Starting derivative checker for second derivatives"));
  EXPECT_THAT(
      log, ::testing::HasSubstr("No errors detected by derivative checker."));
}

INSTANTIATE_TEST_SUITE_P(Problems, IpoptChecker,
                         ::testing::ValuesIn(problem_cases(2, 2)),
                         [](const auto& row) { return row.param.name; });

/// A problem with one wrong entry in its Hessian.
class WrongHessian final : public nlp::Problem {
 public:
  explicit WrongHessian(RollingTime& right) : right_(right) {}

  [[nodiscard]] int num_variables() const override {
    return right_.num_variables();
  }
  [[nodiscard]] int num_constraints() const override {
    return right_.num_constraints();
  }
  [[nodiscard]] nlp::Range variable_range(int index) const override {
    return right_.variable_range(index);
  }
  [[nodiscard]] const nlp::SparsityPattern& jac_g_pattern() const override {
    return right_.jac_g_pattern();
  }
  [[nodiscard]] const nlp::SparsityPattern& hess_lag_pattern() const override {
    return right_.hess_lag_pattern();
  }
  [[nodiscard]] std::string variable_name(int index) const override {
    return right_.variable_name(index);
  }
  [[nodiscard]] std::string constraint_name(int index) const override {
    return right_.constraint_name(index);
  }
  [[nodiscard]] std::string refusal() const override {
    return right_.refusal();
  }

 private:
  bool do_set_point(std::span<const double> x) override {
    return right_.set_point(x);
  }
  [[nodiscard]] double do_eval_f() const override { return right_.eval_f(); }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    right_.eval_grad_f(grad_f);
  }
  void do_eval_g(std::span<double> g) const override { right_.eval_g(g); }
  void do_eval_jac_g(std::span<double> values) const override {
    right_.eval_jac_g(values);
  }
  void do_eval_hess_lag(double objective_factor, std::span<const double> lambda,
                        std::span<double> values) const override {
    right_.eval_hess_lag(objective_factor, lambda, values);
    values.back() += 0.01;
  }

  RollingTime& right_;
};

TEST(IpoptCheckerItself, FindsAnErrorWhereThereIsOne) {
  RollingTime problem(off_centred_scene(), uniform_mesh(2, 2), -0.2);
  WrongHessian wrong(problem);

  const std::string log = checker_log(problem, wrong);

  EXPECT_THAT(log, ::testing::HasSubstr("Derivative checker detected"));
}

}  // namespace
}  // namespace brachisto::testing
