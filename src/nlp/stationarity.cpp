// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "nlp/stationarity.hpp"

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"
#include "math/dense.hpp"

namespace brachisto::nlp {

void make_stationary(const Problem& problem, const std::vector<int>& variables,
                     const std::vector<int>& constraints, PrimalDual& point) {
  const auto size = static_cast<Eigen::Index>(variables.size());
  std::vector<Eigen::Index> row(at(problem.num_variables()), -1);
  std::vector<Eigen::Index> column(at(problem.num_constraints()), -1);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto place = static_cast<std::size_t>(i);
    row[at(variables[place])] = column[at(constraints[place])] = i;
    point.lambda[at(constraints[place])] = 0.0;
  }
  // Jᵀ of these λ = −(∇f + Jᵀ of the others).
  const SparsityPattern& pattern = problem.jac_g_pattern();
  std::vector<double> jac(pattern.num_entries());
  problem.eval_jac_g(jac);
  Eigen::MatrixXd transposed = Eigen::MatrixXd::Zero(size, size);
  pattern.for_each([&](std::size_t entry, int constraint, int variable) {
    const Eigen::Index i = row[at(variable)];
    const Eigen::Index j = column[at(constraint)];
    if (i >= 0 && j >= 0) transposed(i, j) += jac[entry];
  });
  const std::vector<long double> gradient =
      lagrangian_gradient(problem, point.lambda);
  Eigen::VectorXd rest(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    rest[i] = -static_cast<double>(
        gradient[at(variables[static_cast<std::size_t>(i)])]);
  }
  const Eigen::VectorXd lambda = math::solve_square(transposed, rest);
  for (Eigen::Index i = 0; i < size; ++i) {
    point.lambda[at(constraints[static_cast<std::size_t>(i)])] = lambda[i];
  }
}

}  // namespace brachisto::nlp
