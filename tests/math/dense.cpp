// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/dense.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brachisto::math {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Numbers here are of order one, and some dozen operations round each: what has
// no other reason is right to 1e-14.

/// Cauchy's matrix 1/(x_i + y_j) with x_i = i + 1, y_j = j + 1/2.
MatrixXd cauchy(int rows, int cols) {
  MatrixXd A(rows, cols);
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < cols; ++j) A(i, j) = 1.0 / (i + 1 + j + 0.5);
  }
  return A;
}

// Its determinant is Π_{i<j} (x_j − x_i)(y_j − y_i) / Π_{i,j} (x_i + y_j):
// 1/2.5 · … for two rows, (1 · 1)/(1.5 · 2.5 · 2.5 · 3.5).
TEST(Dense, FindsCauchysDeterminant) {
  const double expected = 1.0 / (1.5 * 2.5 * 2.5 * 3.5);
  EXPECT_NEAR(determinant(cauchy(2, 2)), expected, 1e-14);
}

// Solutions are known; the condition number of three rows is below 1e3, that
// of rounding by 1e-16 with a factor of ten.
TEST(Dense, SolvesSquareSystems) {
  const MatrixXd A = cauchy(3, 3);
  const VectorXd x = VectorXd::LinSpaced(3, -1.0, 2.0);
  EXPECT_LT((solve_square(A, A * x) - x).norm(), 1e-12);
  EXPECT_LT((solve_next_to_singular(A, A * x) - x).norm(), 1e-12);
}

// [2 1; 1 2] has 1 and 3.
TEST(Dense, FindsEigenvaluesInOrder) {
  const MatrixXd A{{2.0, 1.0}, {1.0, 2.0}};
  EXPECT_LT((eigenvalues(A) - VectorXd{{1.0, 3.0}}).norm(), 1e-14);
}

TEST(Dense, FindsTheKernel) {
  const MatrixXd A{{1.0, 2.0, 2.0}};
  const MatrixXd kernel = orthonormal_kernel(A);
  ASSERT_EQ(kernel.cols(), 2);
  EXPECT_LT((A * kernel).norm(), 1e-14);
  EXPECT_LT((kernel.transpose() * kernel - MatrixXd::Identity(2, 2)).norm(),
            1e-14);
  EXPECT_EQ(orthonormal_kernel(cauchy(3, 2)).cols(), 0);
}

// Reflections keep lengths, and R'R = A'A of the columns that they act on.
TEST(Dense, TriangularisesByReflections) {
  const MatrixXd A = cauchy(5, 4);
  const Triangularised out = triangularise(A, 3);
  EXPECT_EQ(out.upper(1, 0), 0.0);
  EXPECT_LT((out.upper.transpose() * out.upper -
             A.leftCols(3).transpose() * A.leftCols(3))
                .norm(),
            1e-14);
  EXPECT_NEAR(out.rest.norm(), A.rightCols(1).norm(), 1e-14);
  EXPECT_LT((out.upper.transpose() * out.rest.topRows(3) -
             A.leftCols(3).transpose() * A.rightCols(1))
                .norm(),
            1e-14);
}

// det A = det Q det R: the sign that `mirrored` tells makes up for that of R.
TEST(Dense, TellsWhetherReflectionsMirror) {
  for (int size = 1; size <= 4; ++size) {
    const MatrixXd A = cauchy(size, size);
    const Triangularised out = triangularise(A, size);
    const double det_R = out.upper.diagonal().prod();
    EXPECT_EQ(determinant(A) > 0.0, (det_R > 0.0) != out.mirrored) << size;
  }
}

// x_1 + x_2 = 2 and the same again with 4: the mean is 3, the shortest x has
// equal parts.
TEST(Dense, FindsTheShortestOfLeastSquares) {
  const LeastSquares singular(MatrixXd{{1.0, 1.0}, {1.0, 1.0}});
  EXPECT_LT(
      (singular.solve(VectorXd{{2.0, 4.0}}) - VectorXd{{1.5, 1.5}}).norm(),
      1e-14);
  EXPECT_LT((singular.pseudo_inverse() - MatrixXd::Constant(2, 2, 0.25)).norm(),
            1e-14);
}

}  // namespace
}  // namespace brachisto::math
