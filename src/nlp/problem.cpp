// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/nlp/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto::nlp {

namespace {

void check_size(const char* name, std::size_t got, std::size_t expected) {
  if (got == expected) return;
  throw std::invalid_argument(
      fmt::format("{} has {} entries, expected {}", name, got, expected));
}

void check_point(bool evaluable) {
  if (evaluable) return;
  throw std::logic_error("evaluation asked for at a point that was refused");
}

}  // namespace

bool Problem::has_inequalities() const {
  const auto any = [](int count, auto range_of) {
    for (int i = 0; i < count; ++i) {
      const Range range = range_of(i);
      if (!range.single() && range.bounded()) return true;
    }
    return false;
  };
  return any(num_variables(), [&](int i) { return variable_range(i); }) ||
         any(num_constraints(), [&](int i) { return constraint_range(i); });
}

EliminationOrder Problem::elimination_order() const {
  EliminationOrder order;
  order.columns.resize(at(num_variables() + num_constraints()));
  std::iota(order.columns.begin(), order.columns.end(), 0);
  order.rows = order.columns;
  return order;
}

bool Problem::set_point(std::span<const double> x) {
  check_size("x", x.size(), at(num_variables()));
  const PhaseTimer timer(Phase::Evaluation);
  if (evaluable_ && std::ranges::equal(x, current_point())) return true;
  evaluable_ = false;
  evaluable_ = do_set_point(x);
  return evaluable_;
}

double Problem::eval_f() const {
  check_point(evaluable_);
  const PhaseTimer timer(Phase::Evaluation);
  return do_eval_f();
}

void Problem::eval_grad_f(std::span<double> grad_f) const {
  check_point(evaluable_);
  check_size("grad_f", grad_f.size(), at(num_variables()));
  const PhaseTimer timer(Phase::Evaluation);
  do_eval_grad_f(grad_f);
}

void Problem::eval_g(std::span<double> g) const {
  check_point(evaluable_);
  check_size("g", g.size(), at(num_constraints()));
  const PhaseTimer timer(Phase::Evaluation);
  do_eval_g(g);
}

void Problem::eval_jac_g(std::span<double> values) const {
  check_point(evaluable_);
  check_size("jac_g", values.size(), jac_g_pattern().num_entries());
  const PhaseTimer timer(Phase::Evaluation);
  do_eval_jac_g(values);
}

void Problem::eval_hess_lag(double objective_factor,
                            std::span<const double> lambda,
                            std::span<double> values) const {
  check_point(evaluable_);
  check_size("lambda", lambda.size(), at(num_constraints()));
  check_size("hess_lag", values.size(), hess_lag_pattern().num_entries());
  const PhaseTimer timer(Phase::Evaluation);
  do_eval_hess_lag(objective_factor, lambda, values);
}

}  // namespace brachisto::nlp
