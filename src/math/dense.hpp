// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Decompositions of small dense matrices, and MINPACK's iterations over them
/// as Eigen ports them. Their templates take long to compile: dense.cpp alone
/// does it for matrices whose size is known at run time only, and who calls
/// them includes no more than Eigen/Core.

#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>

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

/// Σ, descending, and V of A = U Σ Vᵀ for an A with as many rows as columns or
/// more.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd right;
};
[[nodiscard]] SingularValues singular_values(const Eigen::MatrixXd& A);

/// Residuals and their derivatives, whose sum of squares is to be least.
struct SumOfSquares {
  Eigen::Index rows = 0;
  std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& residuals)>
      residuals;
  std::function<void(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian)>
      jacobian;
};
/// The minimum next to x by Levenberg's and Marquardt's method (lmder); nothing
/// if it does not converge.
/// \param tolerance  relative, of the sum and of x
[[nodiscard]] std::optional<Eigen::VectorXd> least_sum_of_squares(
    const SumOfSquares& sum, Eigen::VectorXd x, double tolerance);

/// Computes F(x), and tells whether the iteration ends there.
/// \param iterations  begun, 0 at the start
using HybridResidual = std::function<bool(
    const Eigen::VectorXd& x, Eigen::VectorXd& F, Eigen::Index iterations)>;
/// How Powell's hybrid method (hybrd) ended.
struct HybridEnd {
  const char* reason = "";
  int iterations = 0;
  int steps = 0;  ///< each with a Jacobian
};
[[nodiscard]] HybridEnd run_hybrid(const HybridResidual& residual,
                                   Eigen::VectorXd x);

}  // namespace brachisto::math
