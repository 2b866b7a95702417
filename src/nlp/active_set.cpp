// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "nlp/active_set.hpp"

#include <algorithm>
#include <stdexcept>

#include "brachisto/math/index.hpp"
#include "brachisto/nlp/problem.hpp"

namespace brachisto::nlp {

namespace {

/// \param lower, upper  multipliers over their weight
Held held(const Range& range, double value, double lower, double upper) {
  if (range.single()) return Held::AtLower;
  const double above = value - range.lower;
  const double below = range.upper - value;
  if (lower >= above && above <= below) return Held::AtLower;
  return upper >= below ? Held::AtUpper : Held::No;
}

}  // namespace

int ActiveSet::num_free() const {
  return static_cast<int>(std::ranges::count(variables, Held::No));
}

int ActiveSet::num_equations() const {
  return static_cast<int>(constraints.size()) -
         static_cast<int>(std::ranges::count(constraints, Held::No));
}

ActiveSet equations_only(const Problem& problem) {
  ActiveSet active;
  const auto held = [](const Range& range) {
    return range.single() ? Held::AtLower : Held::No;
  };
  for (int i = 0; i < problem.num_variables(); ++i) {
    active.variables.push_back(held(problem.variable_range(i)));
  }
  for (int i = 0; i < problem.num_constraints(); ++i) {
    active.constraints.push_back(held(problem.constraint_range(i)));
  }
  return active;
}

ActiveSet active_set(Problem& problem, const PrimalDual& point) {
  ActiveSet active = equations_only(problem);
  if (!problem.has_inequalities()) return active;
  if (!problem.set_point(point.x)) {
    throw std::domain_error("active set: " + problem.refusal());
  }
  const int n = problem.num_variables();
  const int m = problem.num_constraints();
  for (int i = 0; i < n; ++i) {
    const auto over_weight = [&](const std::vector<double>& z) {
      return z.empty() ? 0.0 : z[at(i)] / problem.weight(i);
    };
    active.variables[at(i)] =
        held(problem.variable_range(i), point.x[at(i)],
             over_weight(point.z_lower), over_weight(point.z_upper));
  }
  std::vector<double> g(at(m));
  problem.eval_g(g);
  for (int i = 0; i < m; ++i) {
    const double lambda = point.lambda.empty()
                              ? 0.0
                              : point.lambda[at(i)] / problem.weight(n + i);
    active.constraints[at(i)] =
        held(problem.constraint_range(i), g[at(i)], -lambda, lambda);
  }
  return active;
}

void set_bound_multipliers(const Problem& problem, const ActiveSet& active,
                           PrimalDual& point) {
  const std::vector<long double> slope =
      lagrangian_gradient(problem, point.lambda);
  point.z_lower.assign(slope.size(), 0.0);
  point.z_upper.assign(slope.size(), 0.0);
  for (std::size_t i = 0; i < slope.size(); ++i) {
    if (problem.variable_range(static_cast<int>(i)).single()) continue;
    if (active.variables[i] == Held::AtLower) {
      point.z_lower[i] = static_cast<double>(slope[i]);
    } else if (active.variables[i] == Held::AtUpper) {
      point.z_upper[i] = static_cast<double>(-slope[i]);
    }
  }
}

}  // namespace brachisto::nlp
