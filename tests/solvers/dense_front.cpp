// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Fronts against the dense algebra of Eigen.

#include "solvers/dense_front.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace brachisto {
namespace {

/// Symmetric, of a saddle: the last unknowns, constraints, come first, so that
/// no pivot is on the diagonal there, and only some are worth a pair.
Eigen::MatrixXd saddle(int variables, int constraints, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const int n = variables + constraints;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (int i = constraints; i < n; ++i) {
    for (int j = 0; j <= i; ++j) {
      matrix(i, j) = matrix(j, i) = entry(random);
    }
  }
  return matrix;
}

FrontStack::Front front_of(const Eigen::MatrixXd& matrix, int candidates) {
  FrontStack::Front front;
  front.reset(static_cast<std::size_t>(matrix.rows()));
  std::iota(front.unknowns.begin(), front.unknowns.end(), 0);
  std::copy_n(matrix.data(), matrix.size(), front.values.data());
  front.candidates = candidates;
  return front;
}

struct Size {
  int variables, constraints;
};
class AFront : public ::testing::TestWithParam<Size> {};

TEST_P(AFront, HasTheInertiaAndTheSolutionOfItsMatrix) {
  const auto [variables, constraints] = GetParam();
  const int n = variables + constraints;
  for (const unsigned seed : {1U, 2U, 3U, 4U, 5U}) {
    const Eigen::MatrixXd matrix = saddle(variables, constraints, seed);
    FrontStack fronts;
    FrontStack::Front front = front_of(matrix, n);
    fronts.eliminate(front, {.zero = 0.0, .complete = true});
    ASSERT_EQ(front.size(), 0);

    const Eigen::VectorXd values =
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    EXPECT_EQ(fronts.negative(), (values.array() < 0.0).count());
    EXPECT_EQ(fronts.zero(), 0);

    const Eigen::VectorXd rhs = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
    Eigen::VectorXd x = rhs;
    const std::span<double> in_place(x.data(), static_cast<std::size_t>(n));
    fronts.forward(in_place);
    fronts.backward(in_place);
    // Multipliers up to 100 may grow entries by so much, rounding with them.
    const double scale = matrix.norm() * x.norm() + rhs.norm();
    EXPECT_LE((matrix * x - rhs).norm(), 100.0 * 1e-16 * n * scale) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, AFront,
                         ::testing::Values(Size{2, 1}, Size{5, 4}, Size{12, 7},
                                           Size{40, 30}));

/// What is eliminated of a part and what is left belong to the whole matrix:
/// Sylvester's law.
TEST(AFrontInTwoParts, HasTheInertiaOfBoth) {
  constexpr int kVariables = 9, kConstraints = 6, kFirst = 8;
  const Eigen::MatrixXd matrix = saddle(kVariables, kConstraints, 7);
  FrontStack fronts;
  FrontStack::Front front = front_of(matrix, kFirst);
  fronts.eliminate(front, {.zero = 0.0});
  ASSERT_GT(front.size(), kVariables + kConstraints - kFirst - 1);
  ASSERT_LT(front.size(), kVariables + kConstraints);
  for (const double value : front.values) ASSERT_LE(std::abs(value), 1e4);

  front.candidates = front.size();
  fronts.eliminate(front, {.zero = 0.0, .complete = true});

  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
  EXPECT_EQ(fronts.negative(), (values.array() < 0.0).count());
}

}  // namespace
}  // namespace brachisto
