// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Decompositions of small dense matrices. Their templates take long to
/// compile: dense.cpp alone does it, and callers include no more than
/// Eigen/Core.

#pragma once

#include <Eigen/Core>
#include <memory>

namespace brachisto::math {

/// x of A x = b for a square A, with partial pivoting; not finite where A is
/// singular.
[[nodiscard]] Eigen::VectorXd solve_square(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& b);
/// The same with full pivoting, for an A next to singular.
[[nodiscard]] Eigen::VectorXd solve_next_to_singular(const Eigen::MatrixXd& A,
                                                     const Eigen::VectorXd& b);
[[nodiscard]] double determinant(const Eigen::MatrixXd& A);

/// Of a symmetric matrix, ascending.
[[nodiscard]] Eigen::VectorXd eigenvalues(const Eigen::MatrixXd& A);

/// Columns of unit length, across each other, that span all x with A x = 0;
/// none where A has full column rank.
[[nodiscard]] Eigen::MatrixXd orthonormal_kernel(const Eigen::MatrixXd& A);

/// What reflections Q make of a matrix whose first columns become triangular.
struct Triangularised {
  Eigen::MatrixXd upper;  ///< R of these columns, as many rows as columns
  Eigen::MatrixXd rest;   ///< Qᵀ times the other columns
  bool mirrored = false;  ///< det Q = −1
};
/// \pre `width` columns, and at least as many rows
[[nodiscard]] Triangularised triangularise(const Eigen::MatrixXd& matrix,
                                           Eigen::Index width);

/// Of all x for which A x is nearest to b the shortest, by a complete
/// orthogonal decomposition, which tells the rank.
class LeastSquares {
 public:
  LeastSquares() = default;
  explicit LeastSquares(const Eigen::MatrixXd& A);

  [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  [[nodiscard]] Eigen::MatrixXd pseudo_inverse() const;

 private:
  struct Decomposition;
  std::shared_ptr<const Decomposition> of_;
};

}  // namespace brachisto::math
