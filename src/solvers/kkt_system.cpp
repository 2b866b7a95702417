// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/kkt_system.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "brachisto/math/phase_clock.hpp"
#include "brachisto/math/stop_condition.hpp"
#include "math/index.hpp"

namespace brachisto {

KktSystem::KktSystem(nlp::Problem& problem, nlp::TangencyCondition* tangency,
                     nlp::ActiveSet active)
    : problem_(problem),
      tangency_(tangency),
      active_(std::move(active)),
      n_(problem.num_variables()),
      m_(problem.num_constraints()),
      given_(at(n_ + m_)),
      x_(at(n_)),
      lambda_(at(m_)),
      grad_f_(at(n_)),
      g_(at(m_)),
      jac_g_(problem.jac_g_pattern().num_entries()),
      hess_lag_(problem.hess_lag_pattern().num_entries()),
      residual_(at(size())) {
  for (int i = 0; i < n_; ++i) {
    given_[at(i)] = active_.variables[at(i)] != nlp::Held::No ? 1 : 0;
  }
  for (int i = 0; i < m_; ++i) {
    given_[at(n_ + i)] = active_.constraints[at(i)] == nlp::Held::No ? 1 : 0;
  }
  if (tangency_ != nullptr) tangency_at_ = tangency_->linearise(x_, lambda_);
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
  std::copy(x.begin(), x.end(), x_.begin());
  std::copy(lambda.begin(), lambda.end(), lambda_.begin());
  check_stop();
  if (!problem_.set_point(x)) return false;
  problem_.eval_grad_f(grad_f_);
  problem_.eval_g(g_);
  problem_.eval_jac_g(jac_g_);

  // The sums of the stationarity conditions cancel at a solution; in long
  // double that leaves only the rounding of their terms.
  wide_.assign(grad_f_.begin(), grad_f_.end());
  const nlp::SparsityPattern& jac = problem_.jac_g_pattern();
  for (std::size_t e = 0; e < jac_g_.size(); ++e) {
    wide_[at(jac.cols[e])] +=
        static_cast<long double>(jac_g_[e]) * lambda_[at(jac.rows[e])];
  }
  const auto bound = [](nlp::Held held, std::span<const double> lower,
                        std::span<const double> upper, int i) {
    return held == nlp::Held::AtUpper ? upper[at(i)] : lower[at(i)];
  };
  const std::span<const double> x_l = problem_.lower();
  const std::span<const double> x_u = problem_.upper();
  for (int i = 0; i < n_; ++i) {
    residual_[at(i)] =
        given(i) ? x_[at(i)] - bound(active_.variables[at(i)], x_l, x_u, i)
                 : static_cast<double>(wide_[at(i)]);
  }
  const std::span<const double> g_l = problem_.constraint_lower();
  const std::span<const double> g_u = problem_.constraint_upper();
  std::copy(g_.begin(), g_.end(), residual_.begin() + n_);
  for (int i = 0; !g_l.empty() && i < m_; ++i) {
    double& value = residual_[at(n_ + i)];
    value = given(n_ + i)
                ? lambda_[at(i)]
                : value - bound(active_.constraints[at(i)], g_l, g_u, i);
  }
  if (tangency_ != nullptr) {
    tangency_at_ = tangency_->linearise(x_, lambda_);
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
  const nlp::SparsityPattern& hess = problem_.hess_lag_pattern();
  for (std::size_t e = 0; e < hess.num_entries(); ++e) {
    const int i = hess.rows[e];
    const int j = hess.cols[e];
    if (!given(i)) put(i, j, hess_lag_[e]);
    if (i != j && !given(j)) put(j, i, hess_lag_[e]);
  }
  const nlp::SparsityPattern& jac = problem_.jac_g_pattern();
  for (std::size_t e = 0; e < jac.num_entries(); ++e) {
    const int row = jac.rows[e];
    const int col = jac.cols[e];
    if (!given(n_ + row)) put(n_ + row, col, jac_g_[e]);
    if (!given(col)) put(col, n_ + row, jac_g_[e]);
  }
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
  problem_.eval_hess_lag(1.0, lambda_, hess_lag_);
}

nlp::SparsityPattern KktSystem::pattern() const {
  nlp::SparsityPattern pattern;
  visit([&](int row, int col, double) {
    pattern.rows.push_back(row);
    pattern.cols.push_back(col);
  });
  return pattern;
}

void KktSystem::jacobian(std::vector<double>& values) const {
  values.clear();
  visit([&](int, int, double value) { values.push_back(value); });
}

}  // namespace brachisto
