// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

namespace brachisto::math {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd solve_square(const MatrixXd& A, const VectorXd& b) {
  return A.partialPivLu().solve(b);
}

VectorXd solve_next_to_singular(const MatrixXd& A, const VectorXd& b) {
  return A.fullPivLu().solve(b);
}

double determinant(const MatrixXd& A) {
  return A.determinant();
}

VectorXd eigenvalues(const MatrixXd& A) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(A, Eigen::EigenvaluesOnly)
      .eigenvalues();
}

MatrixXd orthonormal_kernel(const MatrixXd& A) {
  const Eigen::FullPivLU<MatrixXd> lu(A);
  if (lu.rank() == A.cols()) return {A.cols(), 0};
  const MatrixXd kernel = lu.kernel();
  return kernel.householderQr().householderQ() *
         MatrixXd::Identity(kernel.rows(), kernel.cols());
}

Triangularised triangularise(const MatrixXd& matrix, Index width) {
  const Eigen::HouseholderQR<MatrixXd> qr(matrix.leftCols(width));
  Triangularised out;
  out.rest = matrix.rightCols(matrix.cols() - width);
  out.rest.applyOnTheLeft(qr.householderQ().adjoint());
  out.upper = qr.matrixQR().topRows(width).triangularView<Eigen::Upper>();
  // Every reflection reverses the sign.
  out.mirrored = (qr.hCoeffs().array() != 0.0).count() % 2 != 0;
  return out;
}

struct LeastSquares::Decomposition
    : Eigen::CompleteOrthogonalDecomposition<MatrixXd> {
  using Eigen::CompleteOrthogonalDecomposition<
      MatrixXd>::CompleteOrthogonalDecomposition;
};

LeastSquares::LeastSquares(const MatrixXd& A)
    : of_(std::make_shared<const Decomposition>(A)) {}

VectorXd LeastSquares::solve(const VectorXd& b) const {
  return of_->solve(b);
}

MatrixXd LeastSquares::pseudo_inverse() const {
  return of_->pseudoInverse();
}

}  // namespace brachisto::math
