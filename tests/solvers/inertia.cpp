// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Numbers of eigenvalues by sign, against the eigenvalues themselves.

#include "solvers/inertia.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <stdexcept>
#include <vector>

#include "solvers/quadratic_problem.hpp"
#include "solvers/small_problem.hpp"

namespace brachisto::testing {
namespace {

using Eigen::MatrixXd;

/// The KKT matrix of the free variables, and its eigenvalues by sign.
Inertia of_free_columns(const MatrixXd& H, const MatrixXd& J,
                        const std::vector<int>& free) {
  const auto n = static_cast<Eigen::Index>(free.size());
  const Eigen::Index m = J.rows();
  MatrixXd kkt = MatrixXd::Zero(n + m, n + m);
  kkt.topLeftCorner(n, n) = H(free, free);
  kkt.bottomLeftCorner(m, n) = J(Eigen::all, free);
  kkt.topRightCorner(n, m) = J(Eigen::all, free).transpose();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(kkt);
  // Random matrices of this size have eigenvalues of order one; those that are
  // zero by construction come out as some ε.
  constexpr double kZero = 1e-10;
  Inertia out{.known = true};
  for (const double value : solver.eigenvalues()) {
    if (value > kZero) ++out.positive;
    if (value < -kZero) ++out.negative;
    if (std::abs(value) <= kZero) ++out.zero;
  }
  return out;
}

std::vector<int> all_of(int count) {
  std::vector<int> out;
  for (int i = 0; i < count; ++i) out.push_back(i);
  return out;
}

PrimalDual somewhere(int n, int m) {
  return {std::vector<double>(static_cast<std::size_t>(n), 0.5),
          std::vector<double>(static_cast<std::size_t>(m), 0.25)};
}

void expect_same(const Inertia& found, const Inertia& expected,
                 std::uint32_t seed) {
  EXPECT_TRUE(found.known) << "seed " << seed;
  EXPECT_EQ(found.positive, expected.positive) << "seed " << seed;
  EXPECT_EQ(found.negative, expected.negative) << "seed " << seed;
  EXPECT_EQ(found.zero, expected.zero) << "seed " << seed;
}

TEST(KktInertia, IsThatOfTheEigenvalues) {
  // Indefinite Hessians: most of these are no minima.
  int minima = 0;
  for (std::uint32_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const int n = 2 + static_cast<int>(random.uniform(0.0, 12.0));
    const int m = 1 + static_cast<int>(random.uniform(0.0, 0.7 * n));
    const MatrixXd A = random_matrix(random, n, n);
    const MatrixXd H = A + A.transpose();
    const MatrixXd J = random_matrix(random, m, n);
    QuadraticProblem problem(H, J);

    const Inertia found = kkt_inertia(problem, somewhere(n, m));

    expect_same(found, of_free_columns(H, J, all_of(n)), seed);
    if (found.positive == n) ++minima;
  }
  EXPECT_GT(minima, 0);
  EXPECT_LT(minima, 200);
}

TEST(KktInertia, LeavesOutFixedVariables) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 8;
    const int m = 3;
    const MatrixXd A = random_matrix(random, n, n);
    const MatrixXd H = A + A.transpose();
    const MatrixXd J = random_matrix(random, m, n);
    QuadraticProblem problem(H, J);
    problem.fix(0, 0.5);
    problem.fix(5, 0.5);

    const Inertia found = kkt_inertia(problem, somewhere(n, m));

    expect_same(found, of_free_columns(H, J, {1, 2, 3, 4, 6, 7}), seed);
  }
}

TEST(KktInertia, OfAConvexProblemIsThatOfAMinimum) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 9;
    const int m = 4;
    const MatrixXd A = random_matrix(random, n, n);
    QuadraticProblem problem(A * A.transpose() + MatrixXd::Identity(n, n),
                             random_matrix(random, m, n));

    const Inertia found = kkt_inertia(problem, somewhere(n, m));

    expect_same(found, {n, m, 0, true}, seed);
  }
}

TEST(KktInertia, OfAMaximumHasTheWrongSigns) {
  const int n = 5;
  Random random(1);
  QuadraticProblem problem(-MatrixXd::Identity(n, n),
                           random_matrix(random, 1, n));

  // −I on the null space of J, of dimension n − 1, and one pair ±.
  expect_same(kkt_inertia(problem, somewhere(n, 1)), {1, n, 0, true}, 1);
}

TEST(KktInertia, SeesConstraintsThatDependOnEachOther) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 8;
    const int m = 4;
    const MatrixXd A = random_matrix(random, n, n);
    const MatrixXd H = A * A.transpose() + MatrixXd::Identity(n, n);
    MatrixXd J = random_matrix(random, m, n);
    J.row(3) = 2.0 * J.row(0) - J.row(1);
    QuadraticProblem problem(H, J);

    const Inertia found = kkt_inertia(problem, somewhere(n, m));

    expect_same(found, of_free_columns(H, J, all_of(n)), seed);
    EXPECT_EQ(found.zero, 1) << "seed " << seed;
  }
}

/// More equations than variables that a point satisfies all the same leave no
/// direction, whatever the Hessian is.
TEST(KktInertia, OfMoreConstraintsThanVariablesIsThatOfAMinimum) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 6;
    const int m = 15;
    const MatrixXd J = random_matrix(random, m, n);
    QuadraticProblem problem(-MatrixXd::Identity(n, n), J);

    const Inertia found = kkt_inertia(problem, somewhere(n, m));

    EXPECT_TRUE(found.known) << "seed " << seed;
    EXPECT_EQ(found.positive, n) << "seed " << seed;
  }
}

/// If one direction is left to them along which the Hessian is negative, that
/// is none, whatever signs rounding gives what is zero.
TEST(KktInertia, OfConstraintsThatLeaveAMaximumIsNotThatOfAMinimum) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    const int n = 6;
    const int m = 15;
    MatrixXd J = random_matrix(random, m, n);
    J.col(n - 1) = J.col(0) - J.col(1);  // (1, −1, 0, …, 0, −1) J = 0
    QuadraticProblem problem(-MatrixXd::Identity(n, n), J);

    EXPECT_FALSE(kkt_inertia(problem, somewhere(n, m)).known)
        << "seed " << seed;
  }
}

TEST(KktInertia, UsesTheMultipliers) {
  // At (0, √3) with λ the curvature of HS 7 in x₀, the free direction, is
  // 2 + 4 λ: positive at the solution, negative for λ < −1/2.
  HockSchittkowski7 problem;
  const std::vector<double> x{0.0, HockSchittkowski7::kSolution};

  const Inertia right =
      kkt_inertia(problem, {x, {HockSchittkowski7::kMultiplier}});
  const Inertia wrong = kkt_inertia(problem, {x, {-0.75}});

  EXPECT_EQ(right.positive, 2);
  EXPECT_EQ(right.negative, 1);
  EXPECT_EQ(wrong.positive, 1);
  EXPECT_EQ(wrong.negative, 2);
}

TEST(KktInertia, OfAPointThatIsRefusedThrows) {
  LogarithmicBowl problem;

  EXPECT_THROW(static_cast<void>(kkt_inertia(problem, {{-1.0, 0.0}, {0.0}})),
               std::domain_error);
}

}  // namespace
}  // namespace brachisto::testing
