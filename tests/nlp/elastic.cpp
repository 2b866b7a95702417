// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Limits that give way at a price, against solutions by hand.

#include "nlp/elastic.hpp"

#include <gtest/gtest.h>

#include "brachisto/solvers/program_solvers.hpp"
#include "solvers/inequality_problems.hpp"

namespace brachisto::testing {
namespace {

// Ipopt ends with residuals below 1e-12, and the Hessians are of order one;
// complementarity leaves μ/λ ≤ 1e-12 of a bound.
constexpr double kSolved = 1e-8;

/// minimise (x − 2)² subject to bounds of x, which is g₀, and of 1 − x, g₁.
class TwoRows final : public BoundedProblem {
 public:
  TwoRows(nlp::Range of_x, nlp::Range of_rest) {
    ranges_ = {{-kNoBound, kNoBound}};
    row_ranges_ = {of_x, of_rest};
    jac_ = {{0, 0}, {1, 0}};
    hess_ = {{0, 0}};
  }

 private:
  bool do_set_point(std::span<const double> x) override {
    x_ = x[0];
    return true;
  }
  double do_eval_f() const override { return (x_ - 2.0) * (x_ - 2.0); }
  void do_eval_grad_f(std::span<double> grad_f) const override {
    grad_f[0] = 2.0 * (x_ - 2.0);
  }
  void do_eval_g(std::span<double> g) const override {
    g[0] = x_;
    g[1] = 1.0 - x_;
  }
  void do_eval_jac_g(std::span<double> values) const override {
    values[0] = 1.0;
    values[1] = -1.0;
  }
  void do_eval_hess_lag(double factor, std::span<const double>,
                        std::span<double> values) const override {
    values[0] = 2.0 * factor;
  }
  double x_ = 0.0;
};

struct Found {
  PrimalDual point;  ///< of the program
  double t;
};

Found solved(TwoRows& problem, std::vector<double> give, double price) {
  nlp::Elastic elastic(problem, std::move(give), price);
  const PrimalDual start =
      elastic.with_elasticity({{0.3}, {0.0, 0.0}, {}, {}}, 1.0);
  SolverResult result = solve_with_ipopt(elastic, start, {});
  EXPECT_EQ(result.status, Status::Solved) << result.message;
  const double t = result.point.x.back();
  return {elastic.without_elasticity(std::move(result.point)), t};
}

TEST(Elastic, AboveTheMultiplierIsExact) {
  // x = 1, held from above by a row with two bounds: λ = −f' = 2 < π.
  TwoRows problem({-1.0, 1.0}, {-kNoBound, kNoBound});

  const Found found = solved(problem, {1.0, 0.0}, 3.0);

  EXPECT_NEAR(found.t, 0.0, kSolved);
  ASSERT_EQ(found.point.x.size(), 1U);
  ASSERT_EQ(found.point.lambda.size(), 2U);
  EXPECT_NEAR(found.point.x[0], 1.0, kSolved);
  EXPECT_NEAR(found.point.lambda[0], 2.0, kSolved);
}

TEST(Elastic, BelowTheMultiplierGivesWay) {
  // (d t + 1 − 2)² + π t is least at d t = 1 − π/2d.
  TwoRows problem({-1.0, 1.0}, {-kNoBound, kNoBound});

  const Found found = solved(problem, {2.0, 0.0}, 1.0);

  EXPECT_NEAR(found.t, 0.375, kSolved);
  EXPECT_NEAR(found.point.x[0], 1.75, kSolved);
  EXPECT_NEAR(found.point.lambda[0], 0.5, kSolved);
}

TEST(Elastic, OfBoundsThatExcludeEachOtherGivesWayAtAnyPrice) {
  // x ≤ 0 and 1 − x ≤ 0: both give way by ½.
  TwoRows problem({-kNoBound, 0.0}, {-kNoBound, 0.0});
  for (const double price : {1e2, 1e4}) {
    const Found found = solved(problem, {1.0, 1.0}, price);

    EXPECT_NEAR(found.t, 0.5, kSolved);
    EXPECT_NEAR(found.point.x[0], 0.5, kSolved);
    // Their difference pulls like f', their sum is the price.
    EXPECT_NEAR(found.point.lambda[0] - found.point.lambda[1], 3.0,
                kSolved * price);
    EXPECT_NEAR(found.point.lambda[0] + found.point.lambda[1], price,
                kSolved * price);
  }
}

TEST(Elastic, LeavesEquationsAlone) {
  TwoRows problem({-kNoBound, kNoBound}, {0.0, 0.0});

  const Found found = solved(problem, {0.0, 0.0}, 1.0);

  EXPECT_NEAR(found.point.x[0], 1.0, kSolved);
  EXPECT_NEAR(found.t, 0.0, kSolved);
}

}  // namespace
}  // namespace brachisto::testing
