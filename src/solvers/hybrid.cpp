// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/solvers/hybrid.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <utility>

#include "solvers/counted_residual.hpp"

namespace brachisto {

namespace {

namespace space = Eigen::HybridNonLinearSolverSpace;

/// What Eigen calls; a negative value ends its iteration.
struct Functor {
  CountedResidual& residual;
  const SquareOptions& options;
  const Eigen::DenseIndex* steps = nullptr;  ///< taken, plus one

  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& values) const {
    const auto size = static_cast<std::size_t>(x.size());
    const double norm = residual({x.data(), size}, {values.data(), size});
    const bool enough = *steps > options.max_iterations;
    return norm <= options.tolerance || enough || options.stop.met() ? -1 : 0;
  }
};

const char* reason(space::Status status) {
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

SquareResult solve_by_hybrid(const SquareResidual& residual,
                             std::vector<double> start,
                             const SquareOptions& options) {
  SquareResult result;
  Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(
      start.data(), static_cast<Eigen::Index>(start.size()));
  CountedResidual counted(residual, std::move(start), result);
  Functor functor{counted, options};
  Eigen::HybridNonLinearSolver<Functor> solver(functor);
  functor.steps = &solver.iter;
  solver.parameters.maxfev = std::numeric_limits<Eigen::DenseIndex>::max();
  auto status = solver.solveNumericalDiffInit(x);
  if (std::isnan(result.residual)) {
    conclude(options, "F is not defined at the start", result);
    return result;
  }
  while (status == space::Running) {
    status = solver.solveNumericalDiffOneStep(x);
    ++result.jacobians;
  }
  result.iterations = static_cast<int>(solver.iter) - 1;
  // Eigen does not count the step that ends it.
  if (result.residual <= options.tolerance) ++result.iterations;
  conclude(options, reason(status), result);
  return result;
}

}  // namespace brachisto
