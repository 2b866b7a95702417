// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "brachisto/math/index.hpp"

namespace brachisto::nlp {

namespace {

void check_size(const char* name, const std::vector<double>& values,
                int expected) {
  if (values.size() == at(expected)) return;
  throw std::invalid_argument(fmt::format("{} has {} entries, expected {}",
                                          name, values.size(), expected));
}

/// Keeps the largest value; true if this is one. A NaN must not hide behind a
/// comparison that it fails.
bool worse(double value, double& worst) {
  if (std::isnan(worst) || value <= worst) return false;
  worst = value;
  return true;
}

/// Conditions on the multipliers of bounds, one at a time.
class Multipliers {
 public:
  explicit Multipliers(KktResidual& residual) : residual_(residual) {}

  /// \param distance    from the bound; infinite if there is none
  /// \param multiplier  ≥ 0 at a minimum
  /// \return whether the complementarity is the worst so far
  bool see(double distance, double multiplier, double weight) {
    const double value = multiplier / weight;
    if (std::isinf(distance)) {
      worse(std::abs(value), residual_.sign);
      return false;
    }
    worse(-value, residual_.sign);
    residual_.gap += std::abs(multiplier * distance);
    ++count_;
    return worse(std::abs(value * distance), residual_.complementarity);
  }
  [[nodiscard]] double mean() const {
    return count_ == 0 ? 0.0 : residual_.gap / count_;
  }

 private:
  KktResidual& residual_;
  int count_ = 0;
};

}  // namespace

double KktResidual::max() const {
  // All are ≥ 0, so their sum is not a number iff one of them is not; std::max
  // would pass over it.
  const double sum =
      stationarity + infeasibility + bound_violation + complementarity + sign;
  if (std::isnan(sum)) return sum;
  return std::max(
      {stationarity, infeasibility, bound_violation, complementarity, sign});
}

std::vector<long double> lagrangian_gradient(
    const Problem& problem, const std::vector<double>& lambda) {
  std::vector<double> grad_f(at(problem.num_variables()));
  problem.eval_grad_f(grad_f);
  std::vector<long double> grad(grad_f.begin(), grad_f.end());
  const SparsityPattern& pattern = problem.jac_g_pattern();
  std::vector<double> values(pattern.num_entries());
  problem.eval_jac_g(values);
  pattern.for_each([&](std::size_t entry, int row, int col) {
    grad[at(col)] += static_cast<long double>(values[entry]) * lambda[at(row)];
  });
  return grad;
}

KktResidual kkt_residual(Problem& problem, const PrimalDual& point,
                         const std::function<double(int)>& weight) {
  const int n = problem.num_variables();
  const int m = problem.num_constraints();
  check_size("lambda", point.lambda, m);
  const bool no_z = point.z_lower.empty() && point.z_upper.empty();
  if (!no_z) {
    check_size("z_lower", point.z_lower, n);
    check_size("z_upper", point.z_upper, n);
  }
  if (!problem.set_point(point.x)) {
    throw std::domain_error("KKT residual: " + problem.refusal());
  }
  // Sums in long double, so that what is reported is the residual of the point
  // and not of this summation.
  const std::vector<long double> grad =
      lagrangian_gradient(problem, point.lambda);
  KktResidual residual;
  Multipliers multipliers(residual);
  int worst_variable = -1;
  int worst_multiplier = -1;
  for (int i = 0; i < n; ++i) {
    const Range range = problem.variable_range(i);
    const double x = point.x[at(i)];
    if (range.single()) {
      worse(std::abs(x - range.lower), residual.bound_violation);
      continue;
    }
    const double z_lower = no_z ? 0.0 : point.z_lower[at(i)];
    const double z_upper = no_z ? 0.0 : point.z_upper[at(i)];
    const auto slope = static_cast<double>(grad[at(i)] - z_lower + z_upper);
    if (worse(std::abs(slope) / weight(i), residual.stationarity)) {
      worst_variable = i;
    }
    if (!range.bounded() && no_z) continue;
    worse(range.lower - x, residual.bound_violation);
    worse(x - range.upper, residual.bound_violation);
    const bool at_lower = multipliers.see(x - range.lower, z_lower, weight(i));
    const bool at_upper = multipliers.see(range.upper - x, z_upper, weight(i));
    if (at_lower || at_upper) worst_multiplier = i;
  }
  std::vector<double> g(at(m));
  problem.eval_g(g);
  int worst_constraint = -1;
  for (int i = 0; i < m; ++i) {
    const Range range = problem.constraint_range(i);
    const double value = g[at(i)];
    if (range.single()) {
      if (worse(std::abs(value - range.lower), residual.infeasibility)) {
        worst_constraint = n + i;
      }
      continue;
    }
    const bool below = worse(range.lower - value, residual.infeasibility);
    const bool above = worse(value - range.upper, residual.infeasibility);
    if (below || above) worst_constraint = n + i;
    // λ belongs to the nearer bound: with the wrong sign for that it is an
    // error of the sign, not one of complementarity with the other.
    const double to_lower = value - range.lower;
    const double to_upper = range.upper - value;
    const double lambda = point.lambda[at(i)];
    const bool is_worst =
        to_lower <= to_upper ? multipliers.see(to_lower, -lambda, weight(n + i))
                             : multipliers.see(to_upper, lambda, weight(n + i));
    if (is_worst) worst_multiplier = n + i;
  }
  const auto name_of = [&](int i) {
    if (i < 0) return std::string();
    return i < n ? problem.variable_name(i) : problem.constraint_name(i - n);
  };
  residual.worst_variable = name_of(worst_variable);
  residual.worst_constraint = name_of(worst_constraint);
  residual.worst_multiplier = name_of(worst_multiplier);
  residual.barrier_parameter = multipliers.mean();
  return residual;
}

KktResidual kkt_residual(Problem& problem, const PrimalDual& point) {
  return kkt_residual(problem, point,
                      [&](int index) { return problem.weight(index); });
}

}  // namespace brachisto::nlp
