// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/kkt_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"

namespace brachisto {

KktSystem::KktSystem(nlp::Problem& problem, nlp::TangencyCondition* tangency,
                     nlp::ActiveSet active)
    : problem_(problem),
      tangency_(tangency),
      active_(std::move(active)),
      n_(problem.num_variables()),
      m_(problem.num_constraints()),
      given_(at(n_ + m_)),
      jac_g_(problem.jac_g_pattern().num_entries()),
      residual_(at(size())) {
  for (int i = 0; i < n_; ++i) {
    given_[at(i)] = active_.variables[at(i)] != nlp::Held::No ? 1 : 0;
  }
  for (int i = 0; i < m_; ++i) {
    given_[at(n_ + i)] = active_.constraints[at(i)] == nlp::Held::No ? 1 : 0;
  }
}

nlp::EliminationOrder KktSystem::elimination_order() const {
  nlp::EliminationOrder order = problem_.elimination_order();
  if (tangency_ != nullptr) {
    order.columns.push_back(n_ + m_);
    order.rows.push_back(n_ + m_);
    ++order.border;
  }
  return order;
}

bool KktSystem::evaluate(std::span<const double> x,
                         std::span<const double> lambda, double phi) {
  const PhaseTimer timer(Phase::Evaluation);
  if (tangency_ != nullptr) tangency_->set_parameter(phi);
  lambda_ = lambda;
  check_stop();
  if (!problem_.set_point(x)) return false;
  const std::span<double> grad_f = std::span(residual_).first(at(n_));
  problem_.eval_grad_f(grad_f);
  problem_.eval_g(std::span(residual_).subspan(at(n_), at(m_)));
  problem_.eval_jac_g(jac_g_);

  // The sums of the stationarity conditions cancel at a solution; in long
  // double that leaves only the rounding of their terms.
  std::vector<long double> wide(grad_f.begin(), grad_f.end());
  problem_.jac_g_pattern().for_each([&](std::size_t entry, int row, int col) {
    wide[at(col)] += static_cast<long double>(jac_g_[entry]) * lambda_[at(row)];
  });
  for (int i = 0; i < n_; ++i) {
    residual_[at(i)] = given(i)
                           ? x[at(i)] - held_value(problem_.variable_range(i),
                                                   active_.variables[at(i)])
                           : static_cast<double>(wide[at(i)]);
  }
  for (int i = 0; i < m_; ++i) {
    double& value = residual_[at(n_ + i)];
    value = given(n_ + i) ? lambda_[at(i)]
                          : value - held_value(problem_.constraint_range(i),
                                               active_.constraints[at(i)]);
  }
  if (tangency_ != nullptr) {
    tangency_at_ = tangency_->linearise(x, lambda);
    residual_.back() = tangency_at_.residual;
  }
  return true;
}

double KktSystem::max_residual() const {
  double worst = 0.0;
  for (const double value : residual_) {
    if (!(std::abs(value) <= worst)) worst = std::abs(value);
    if (std::isnan(worst)) break;
  }
  return worst;
}

template <class Put>
void KktSystem::visit(Put&& put) const {
  problem_.hess_lag_pattern().for_each([&](std::size_t entry, int i, int j) {
    if (!given(i)) put(i, j, hess_lag_[entry]);
    if (i != j && !given(j)) put(j, i, hess_lag_[entry]);
  });
  problem_.jac_g_pattern().for_each([&](std::size_t entry, int row, int col) {
    if (!given(n_ + row)) put(n_ + row, col, jac_g_[entry]);
    if (!given(col)) put(col, n_ + row, jac_g_[entry]);
  });
  for (int i = 0; i < n_ + m_; ++i) {
    if (given(i)) put(i, i, 1.0);
  }
  if (tangency_ == nullptr) return;
  const int last = n_ + m_;
  const nlp::SparseVector& rates = tangency_->fixed_rates();
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    put(rates.index[e], last, -rates.value[e]);
  }
  const auto put_row = [&](const nlp::SparseVector& row, int offset) {
    for (std::size_t e = 0; e < row.index.size(); ++e) {
      put(last, offset + row.index[e], row.value[e]);
    }
  };
  put_row(tangency_at_.by_x, 0);
  put_row(tangency_at_.by_lambda, n_);
  put(last, last, tangency_at_.by_parameter);
}

void KktSystem::evaluate_jacobian() {
  check_stop();
  hess_lag_.resize(problem_.hess_lag_pattern().num_entries());
  problem_.eval_hess_lag(1.0, lambda_, hess_lag_);
}

nlp::SparsityPattern KktSystem::pattern() const {
  nlp::SparsityPattern pattern;
  visit([&](int row, int col, double) { pattern.add(row, col); });
  return pattern;
}

void KktSystem::jacobian(std::vector<double>& values) const {
  values.clear();
  visit([&](int, int, double value) { values.push_back(value); });
}

}  // namespace brachisto
