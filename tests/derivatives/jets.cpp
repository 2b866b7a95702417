// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Values of f, g, gradient, Jacobian and Hessian against jets over all
// variables of a problem of two elements; its sparsity against the zeros of the
// jets.

#include "brachisto/math/jet.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "derivatives/literal_problem.hpp"
#include "support/random_points.hpp"
#include "support/rounding.hpp"

namespace brachisto::testing {
namespace {

constexpr int kLargestDegree = 8;
constexpr int kElements = 2;
/// Five unknowns per node of an off-centred body.
constexpr int kMostUnknowns = 5 * (kElements * kLargestDegree + 1);
using JetOfAll = math::Jet2<double, kMostUnknowns>;

struct Dense {
  double f;
  Eigen::VectorXd grad_f, g;
  Eigen::MatrixXd jac_g;
  Eigen::MatrixXd hess_lag;  ///< lower triangle
};

/// By the library; entries at one position add up.
Dense by_library(RollingTime& problem, const std::vector<double>& x,
                 double objective_factor, const std::vector<double>& lambda) {
  const int n = problem.num_variables(), m = problem.num_constraints();
  Dense out{0.0, Eigen::VectorXd(n), Eigen::VectorXd(m),
            Eigen::MatrixXd::Zero(m, n), Eigen::MatrixXd::Zero(n, n)};
  if (!problem.set_point(x)) {
    ADD_FAILURE() << problem.refusal();
    return out;
  }
  const auto& jac = problem.jac_g_pattern();
  const auto& hess = problem.hess_lag_pattern();
  std::vector<double> jac_values(jac.num_entries());
  std::vector<double> hess_values(hess.num_entries());
  out.f = problem.eval_f();
  problem.eval_grad_f({out.grad_f.data(), static_cast<std::size_t>(n)});
  problem.eval_g({out.g.data(), static_cast<std::size_t>(m)});
  problem.eval_jac_g(jac_values);
  problem.eval_hess_lag(objective_factor, lambda, hess_values);
  for (std::size_t e = 0; e < jac.num_entries(); ++e) {
    out.jac_g(jac[e].row, jac[e].col) += jac_values[e];
  }
  for (std::size_t e = 0; e < hess.num_entries(); ++e) {
    out.hess_lag(hess[e].row, hess[e].col) += hess_values[e];
  }
  return out;
}

/// By jets of the formulas written down again.
Dense by_jets(const ProblemCase& row, const std::vector<double>& x,
              double objective_factor, const std::vector<double>& lambda) {
  const auto n = static_cast<int>(x.size());
  const auto m = static_cast<int>(lambda.size());
  std::vector<JetOfAll> unknowns;
  for (int i = 0; i < n; ++i) {
    unknowns.push_back(JetOfAll::variable(x[static_cast<std::size_t>(i)], i));
  }
  const Functions<JetOfAll> functions = literal_functions(row, unknowns);

  Dense out{functions.f.value, Eigen::VectorXd(n), Eigen::VectorXd(m),
            Eigen::MatrixXd::Zero(m, n), Eigen::MatrixXd::Zero(n, n)};
  JetOfAll lagrangian = objective_factor * functions.f;
  for (int i = 0; i < m; ++i) {
    const JetOfAll& g = functions.g[static_cast<std::size_t>(i)];
    out.g(i) = g.value;
    for (int c = 0; c < n; ++c) {
      out.jac_g(i, c) = g.gradient[static_cast<std::size_t>(c)];
    }
    lagrangian += lambda[static_cast<std::size_t>(i)] * g;
  }
  for (int i = 0; i < n; ++i) {
    out.grad_f(i) = functions.f.gradient[static_cast<std::size_t>(i)];
    for (int c = 0; c <= i; ++c) {
      out.hess_lag(i, c) = lagrangian.hessian[JetOfAll::pair(i, c)];
    }
  }
  return out;
}

/// Entries are sums over p + 1 nodes or p points, each of half a dozen factors
/// that were rounded; the largest entry of a matrix is their size.
double rounding(int degree, double size) {
  return ulps(8.0 * (degree + 1), 1.0 + size);
}

template <class Matrix>
void expect_equal(const char* what, const Matrix& got, const Matrix& expected,
                  int degree) {
  Eigen::Index row = 0, col = 0;
  const double worst = (got - expected).cwiseAbs().maxCoeff(&row, &col);
  EXPECT_LE(worst, rounding(degree, expected.cwiseAbs().maxCoeff()))
      << what << " entry (" << row << ", " << col << "): " << got(row, col)
      << " instead of " << expected(row, col);
}

class Jets : public ::testing::TestWithParam<ProblemCase> {};

TEST_P(Jets, HaveTheValuesAndDerivativesOfTheProblem) {
  RollingTime problem = GetParam().problem();
  const int p = problem.mesh().degree;
  for (const double start_speed : {1.0, 1e-6}) {
    constexpr std::uint32_t kSeed = 5;
    Random random(kSeed);
    SCOPED_TRACE(::testing::Message()
                 << "seed " << kSeed << " start speed " << start_speed);
    const std::vector<double> x = random_point(problem, random, start_speed);
    const std::vector<double> lambda =
        random.vector(problem.num_constraints(), -1.0, 1.0);
    const double factor = random.uniform(0.5, 1.5);

    const Dense got = by_library(problem, x, factor, lambda);
    const Dense expected = by_jets(GetParam(), x, factor, lambda);

    EXPECT_NEAR(got.f, expected.f, rounding(p, std::abs(expected.f)));
    expect_equal("∇f", got.grad_f, expected.grad_f, p);
    // Defects cancel: their size is that of their terms, the states times the
    // entries of D.
    EXPECT_LE((got.g - expected.g).cwiseAbs().maxCoeff(),
              rounding(p, 8.0 * expected.jac_g.cwiseAbs().maxCoeff()));
    expect_equal("∂g/∂x", got.jac_g, expected.jac_g, p);
    expect_equal("∇²(f + λᵀg)", got.hess_lag, expected.hess_lag, p);
  }
}

TEST_P(Jets, HaveNoNonzeroOutsideThePattern) {
  RollingTime problem = GetParam().problem();
  Random random(6);
  const std::vector<double> x = random_point(problem, random);
  const std::vector<double> lambda =
      random.vector(problem.num_constraints(), 0.5, 1.0);

  const Dense jets = by_jets(GetParam(), x, 1.0, lambda);

  // Jets of formulas that do not contain a variable are exactly zero in it.
  Eigen::MatrixXi jac =
      Eigen::MatrixXi::Zero(jets.jac_g.rows(), jets.jac_g.cols());
  Eigen::MatrixXi hess =
      Eigen::MatrixXi::Zero(jets.hess_lag.rows(), jets.hess_lag.cols());
  const auto mark = [](const nlp::SparsityPattern& pattern,
                       Eigen::MatrixXi& marks) {
    for (std::size_t e = 0; e < pattern.num_entries(); ++e) {
      marks(pattern[e].row, pattern[e].col) = 1;
    }
  };
  mark(problem.jac_g_pattern(), jac);
  mark(problem.hess_lag_pattern(), hess);
  for (Eigen::Index i = 0; i < jac.rows(); ++i) {
    for (Eigen::Index c = 0; c < jac.cols(); ++c) {
      EXPECT_TRUE(jac(i, c) == 1 || jets.jac_g(i, c) == 0.0)
          << problem.constraint_name(static_cast<int>(i)) << " by "
          << problem.variable_name(static_cast<int>(c));
    }
  }
  for (Eigen::Index i = 0; i < hess.rows(); ++i) {
    for (Eigen::Index c = 0; c <= i; ++c) {
      EXPECT_TRUE(hess(i, c) == 1 || jets.hess_lag(i, c) == 0.0)
          << problem.variable_name(static_cast<int>(i)) << " and "
          << problem.variable_name(static_cast<int>(c));
    }
  }
}

TEST_P(Jets, AreMatchedByAPatternInRangeAndInTheLowerTriangle) {
  const RollingTime problem = GetParam().problem();
  const auto& jac = problem.jac_g_pattern();
  const auto& hess = problem.hess_lag_pattern();
  jac.for_each([&](std::size_t entry, int row, int col) {
    EXPECT_GE(row, 0) << "entry " << entry;
    EXPECT_LT(row, problem.num_constraints()) << "entry " << entry;
    EXPECT_GE(col, 0) << "entry " << entry;
    EXPECT_LT(col, problem.num_variables()) << "entry " << entry;
  });
  hess.for_each([&](std::size_t entry, int row, int col) {
    EXPECT_LT(row, problem.num_variables()) << "entry " << entry;
    EXPECT_LE(col, row) << "entry " << entry;
    EXPECT_GE(col, 0) << "entry " << entry;
  });
}

TEST_P(Jets, AreMatchedByAPatternFixedForLife) {
  RollingTime problem = GetParam().problem();
  const nlp::SparsityPattern jac = problem.jac_g_pattern();
  const nlp::SparsityPattern hess = problem.hess_lag_pattern();
  Random random(7);
  const std::vector<double> lambda(
      static_cast<std::size_t>(problem.num_constraints()));

  static_cast<void>(
      by_library(problem, random_point(problem, random), 0.0, lambda));

  EXPECT_EQ(problem.jac_g_pattern(), jac);
  EXPECT_EQ(problem.hess_lag_pattern(), hess);
}

INSTANTIATE_TEST_SUITE_P(Problems, Jets,
                         ::testing::ValuesIn(problem_cases(kLargestDegree,
                                                           kElements)),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace brachisto::testing
