// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "nlp/tiny_problem.hpp"
#include "support/numbers.hpp"

namespace brachisto::testing {
namespace {

using nlp::kkt_residual;
using nlp::KktResidual;

// 2 x_i + λ_0 + λ_1 x_j = 0 at x = (1, 1): any λ_0 + λ_1 = −2 will do.
const std::vector<double> kTinySolution{1.0, 1.0, 2.0};
const std::vector<double> kTinyMultipliers{-0.5, -1.5};

TEST(KktResidual, VanishesAtASolution) {
  TinyProblem problem;

  const KktResidual residual =
      kkt_residual(problem, {kTinySolution, kTinyMultipliers});

  EXPECT_EQ(residual.stationarity, 0.0);
  EXPECT_EQ(residual.infeasibility, 0.0);
  EXPECT_EQ(residual.bound_violation, 0.0);
  EXPECT_EQ(residual.max(), 0.0);
}

TEST(KktResidual, NamesTheWorstVariableAndConstraint) {
  TinyProblem problem;
  const std::vector<double> x{0.5, 3.0, 2.0};
  const std::vector<double> lambda{1.0, 2.0};

  const KktResidual residual = kkt_residual(problem, {x, lambda});

  // Stationarity 2·½ + 1 + 2·3 = 8 and 2·3 + 1 + 2·½ = 8 …
  EXPECT_DOUBLE_EQ(residual.stationarity, 8.0);
  // … and g = (½ + 3 − 2, ½·3 − 1).
  EXPECT_DOUBLE_EQ(residual.infeasibility, 1.5);
  EXPECT_EQ(residual.worst_constraint, "g[0]");
  EXPECT_EQ(residual.bound_violation, 0.0);
  EXPECT_DOUBLE_EQ(residual.max(), 8.0);

  problem.spoil_grad_f = {0.0, 0.25, 0.0};
  problem.spoil_g = {0.0, -3.0};
  const KktResidual spoiled = kkt_residual(problem, {x, lambda});
  EXPECT_DOUBLE_EQ(spoiled.stationarity, 8.25);
  EXPECT_EQ(spoiled.worst_variable, "x[1]");
  EXPECT_DOUBLE_EQ(spoiled.infeasibility, 2.5);
  EXPECT_EQ(spoiled.worst_constraint, "g[1]");
}

TEST(KktResidual, AsksAFixedVariableForItsValueOnly) {
  TinyProblem problem;
  const std::vector<double> x{1.0, 1.0, 2.0 + 0.125};

  const KktResidual residual = kkt_residual(problem, {x, kTinyMultipliers});

  // ∂(f + λᵀg)/∂x_2 = 5 + ½ does not count.
  EXPECT_EQ(residual.stationarity, 0.0);
  EXPECT_EQ(residual.bound_violation, 0.125);
  EXPECT_EQ(residual.infeasibility, 0.125);
}

TEST(KktResidual, MaxIsTheWorstOfTheThree) {
  KktResidual residual;
  residual.stationarity = 1.0;
  residual.infeasibility = 2.0;
  residual.bound_violation = 3.0;

  EXPECT_EQ(residual.max(), 3.0);
}

TEST(KktResidual, NeverHidesANotANumber) {
  for (std::size_t i = 0; i < 2; ++i) {
    TinyProblem problem;
    problem.spoil_grad_f[i] = kNaN;
    // The other one is not zero, be it before or after.
    problem.spoil_grad_f[1 - i] = 7.0;

    const KktResidual residual =
        kkt_residual(problem, {kTinySolution, kTinyMultipliers});

    EXPECT_TRUE(std::isnan(residual.stationarity)) << "variable " << i;
    EXPECT_EQ(residual.worst_variable,
              problem.variable_name(static_cast<int>(i)));
    EXPECT_TRUE(std::isnan(residual.max())) << "variable " << i;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    TinyProblem problem;
    problem.spoil_g[i] = kNaN;
    problem.spoil_g[1 - i] = 7.0;

    const KktResidual residual =
        kkt_residual(problem, {kTinySolution, kTinyMultipliers});

    EXPECT_TRUE(std::isnan(residual.infeasibility)) << "constraint " << i;
    EXPECT_EQ(residual.worst_constraint,
              problem.constraint_name(static_cast<int>(i)));
    EXPECT_TRUE(std::isnan(residual.max())) << "constraint " << i;
  }
}

TEST(KktResidual, NeverHidesAFixedVariableThatIsNotANumber) {
  TinyProblem problem;
  const std::vector<double> x{1.0, 1.0, kNaN};

  const KktResidual residual = kkt_residual(problem, {x, kTinyMultipliers});

  EXPECT_TRUE(std::isnan(residual.bound_violation));
  EXPECT_TRUE(std::isnan(residual.max()));
}

TEST(KktResidual, MaxIsNotANumberIfAnyOfTheThreeIs) {
  KktResidual stationarity, infeasibility, bound_violation;
  stationarity.stationarity = kNaN;
  infeasibility.infeasibility = kNaN;
  bound_violation.bound_violation = kNaN;

  EXPECT_TRUE(std::isnan(stationarity.max()));
  EXPECT_TRUE(std::isnan(infeasibility.max()));
  EXPECT_TRUE(std::isnan(bound_violation.max()));
}

TEST(KktResidual, SaysWhyAPointIsNotEvaluable) {
  TinyProblem problem;
  const std::vector<double> x{-1.0, 1.0, 2.0};

  try {
    static_cast<void>(kkt_residual(problem, {x, kTinyMultipliers}));
    FAIL() << "no exception";
  } catch (const std::domain_error& error) {
    EXPECT_STREQ(error.what(), "KKT residual: x[0] is negative");
  }
}

TEST(KktResidual, RefusesVectorsOfTheWrongLength) {
  TinyProblem problem;
  const std::vector<double> one{1.0};
  const std::vector<double> three{1.0, 1.0, 1.0};

  EXPECT_THROW(
      static_cast<void>(kkt_residual(problem, {one, kTinyMultipliers})),
      std::invalid_argument);
  EXPECT_THROW(static_cast<void>(kkt_residual(problem, {kTinySolution, one})),
               std::invalid_argument);
  EXPECT_THROW(static_cast<void>(kkt_residual(problem, {kTinySolution, three})),
               std::invalid_argument);
}

}  // namespace
}  // namespace brachisto::testing
