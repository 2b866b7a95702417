// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "math/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>

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

SingularValues singular_values(const MatrixXd& A) {
  const Eigen::JacobiSVD<MatrixXd> svd(A, Eigen::ComputeThinV);
  return {svd.singularValues(), svd.matrixV()};
}

namespace {

/// What Eigen calls for a sum of squares.
struct SumFunctor {
  const SumOfSquares& sum;

  [[nodiscard]] Index values() const { return sum.rows; }
  int operator()(const VectorXd& x, VectorXd& residuals) const {
    sum.residuals(x, residuals);
    return 0;
  }
  int df(const VectorXd& x, MatrixXd& jacobian) const {
    sum.jacobian(x, jacobian);
    return 0;
  }
};

/// What Eigen calls for a square system; a negative value ends its iteration.
struct HybridFunctor {
  const HybridResidual& residual;
  const Eigen::DenseIndex* iterations = nullptr;

  int operator()(const VectorXd& x, VectorXd& F) const {
    return residual(x, F, *iterations) ? -1 : 0;
  }
};

const char* reason(Eigen::HybridNonLinearSolverSpace::Status status) {
  namespace space = Eigen::HybridNonLinearSolverSpace;
  switch (status) {
    case space::Running:
    case space::RelativeErrorTooSmall:
      return "the steps became smaller than √ε of the unknowns";
    case space::TooManyFunctionEvaluation:
      return "too many evaluations";
    case space::TolTooSmall:
      return "the steps cannot become smaller";
    case space::NotMakingProgressJacobian:
      return "five Jacobians in a row made no good progress";
    case space::NotMakingProgressIterations:
      return "ten iterations in a row made no good progress";
    case space::ImproperInputParameters:
      return "the system has no unknowns";
    case space::UserAsked:
      break;
  }
  return "stopped at a limit";
}

}  // namespace

std::optional<VectorXd> least_sum_of_squares(const SumOfSquares& sum,
                                             VectorXd x, double tolerance) {
  namespace space = Eigen::LevenbergMarquardtSpace;
  SumFunctor functor{sum};
  Eigen::LevenbergMarquardt<SumFunctor> solver(functor);
  solver.parameters.ftol = tolerance;
  solver.parameters.xtol = tolerance;
  const space::Status status = solver.minimize(x);
  const bool failed = status == space::TooManyFunctionEvaluation ||
                      status == space::ImproperInputParameters;
  if (failed || !x.allFinite()) return std::nullopt;
  return x;
}

HybridEnd run_hybrid(const HybridResidual& residual, VectorXd x) {
  HybridFunctor functor{residual};
  Eigen::HybridNonLinearSolver<HybridFunctor> solver(functor);
  functor.iterations = &solver.iter;
  solver.parameters.maxfev = std::numeric_limits<Eigen::DenseIndex>::max();
  HybridEnd end;
  auto status = solver.solveNumericalDiffInit(x);
  while (status == Eigen::HybridNonLinearSolverSpace::Running) {
    status = solver.solveNumericalDiffOneStep(x);
    ++end.steps;
  }
  end.reason = reason(status);
  end.iterations = static_cast<int>(solver.iter) - 1;
  return end;
}

}  // namespace brachisto::math
