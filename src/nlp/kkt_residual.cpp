// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/kkt_residual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace brachisto::nlp {

double KktResidual::max() const {
  // All are ≥ 0, so their sum is not a number iff one of them is not; std::max
  // would pass over it.
  const double sum = stationarity + infeasibility + bound_violation;
  if (std::isnan(sum)) return sum;
  return std::max({stationarity, infeasibility, bound_violation});
}

KktResidual kkt_residual(Problem& problem, std::span<const double> x,
                         std::span<const double> lambda) {
  const auto m = static_cast<std::size_t>(problem.num_constraints());
  if (lambda.size() != m) {
    throw std::invalid_argument(
        fmt::format("lambda has {} entries, expected {}", lambda.size(), m));
  }
  if (!problem.set_point(x)) {
    throw std::domain_error("KKT residual: " + problem.refusal());
  }
  // Sums in long double, so that what is reported is the residual of the point
  // and not of this summation.
  const auto n = static_cast<std::size_t>(problem.num_variables());
  std::vector<double> grad_f(n);
  problem.eval_grad_f(grad_f);
  std::vector<long double> grad(grad_f.begin(), grad_f.end());
  const SparsityPattern& pattern = problem.jac_g_pattern();
  std::vector<double> values(pattern.num_entries());
  problem.eval_jac_g(values);
  for (std::size_t e = 0; e < values.size(); ++e) {
    grad[static_cast<std::size_t>(pattern.cols[e])] +=
        static_cast<long double>(values[e]) *
        lambda[static_cast<std::size_t>(pattern.rows[e])];
  }

  KktResidual residual;
  // A NaN must not hide behind a comparison that it fails.
  const auto worse = [](double value, double& worst) {
    if (std::isnan(worst) || value <= worst) return false;
    worst = value;
    return true;
  };
  int worst_variable = -1;
  for (std::size_t i = 0; i < n; ++i) {
    const double lower = problem.lower()[i];
    if (lower == problem.upper()[i]) {
      worse(std::abs(x[i] - lower), residual.bound_violation);
    } else if (worse(std::abs(static_cast<double>(grad[i])),
                     residual.stationarity)) {
      worst_variable = static_cast<int>(i);
    }
  }
  std::vector<double> g(static_cast<std::size_t>(problem.num_constraints()));
  problem.eval_g(g);
  int worst_constraint = -1;
  for (std::size_t i = 0; i < g.size(); ++i) {
    if (worse(std::abs(g[i]), residual.infeasibility)) {
      worst_constraint = static_cast<int>(i);
    }
  }
  if (worst_variable >= 0) {
    residual.worst_variable = problem.variable_name(worst_variable);
  }
  if (worst_constraint >= 0) {
    residual.worst_constraint = problem.constraint_name(worst_constraint);
  }
  return residual;
}

}  // namespace brachisto::nlp
