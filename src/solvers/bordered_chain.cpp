// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/bordered_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/clock.hpp"
#include "brachisto/math/index.hpp"
#include "solvers/chain_ldlt.hpp"

namespace brachisto {

std::unique_ptr<BorderedChain> BorderedChain::make(const KktSystem& system) {
  std::unique_ptr<ChainLdlt> chain =
      make_chain_ldlt(system.problem(), system.active());
  if (!chain) return nullptr;
  return std::unique_ptr<BorderedChain>(
      new BorderedChain(system, std::move(chain)));
}

BorderedChain::BorderedChain(const KktSystem& system,
                             std::unique_ptr<ChainLdlt> chain)
    : system_(system), chain_(std::move(chain)) {}

BorderedChain::~BorderedChain() = default;

/// rhs −= C v, v the given unknowns in x, summed in long double. As given
/// unknowns have no rows in C, x may be rhs.
///
/// \param rounded  called with each row and what its rounding loses
template <class Rounded>
void BorderedChain::couple(std::span<const double> x, std::span<double> rhs,
                           Rounded&& rounded) const {
  const std::array<std::span<const double>, 2> values = {system_.hess_lag(),
                                                         system_.jac_g()};
  const std::span<const ChainMap::Coupling> couplings = chain_->couplings();
  for (auto c = couplings.begin(); c != couplings.end();) {
    const std::size_t row = at(c->unknown);
    long double sum = rhs[row];
    for (; c != couplings.end() && at(c->unknown) == row; ++c) {
      sum -= static_cast<long double>(values[at(c->array)][at(c->entry)]) *
             x[at(c->absent)];
    }
    rhs[row] = static_cast<double>(sum);
    rounded(row, static_cast<double>(sum - rhs[row]));
  }
}

/// qᵀu + sᵀv of the vector (u, v).
long double BorderedChain::tangency_product(std::span<const double> x) const {
  return system_.tangency_row().times(x, system_.problem().num_variables());
}

bool BorderedChain::factorise() {
  const PhaseTimer timer(Phase::Factorisation);
  const std::array<std::span<const double>, 2> values = {system_.hess_lag(),
                                                         system_.jac_g()};
  pivot_ = 0.0;
  at_once_ = false;
  if (!chain_->factorise(values) || chain_->inertia().zero > 0) return false;
  pivot_ = 1.0;
  if (system_.tangency() == nullptr) return true;
  column_.assign(at(system_.size()), 0.0);
  const nlp::SparseVector& rates = system_.tangency()->fixed_rates();
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    column_[at(rates.index[e])] = -rates.value[e];
  }
  couple(column_, column_, [](std::size_t, double) {});
  chain_->solve(column_);
  pivot_ = static_cast<double>(system_.tangency_row().by_parameter -
                               tangency_product(column_));
  return std::isfinite(pivot_) && pivot_ != 0.0;
}

void BorderedChain::rescale() {
  chain_->set_scale(chain_of(system_.problem(), system_.active()).scale);
}

void BorderedChain::forget_pivots() {
  chain_->forget_pivots();
}

int BorderedChain::determinant_sign() const {
  if (pivot_ == 0.0 || !std::isfinite(pivot_)) return 0;
  const int sign = chain_->inertia().negative % 2 == 0 ? 1 : -1;
  return pivot_ > 0.0 ? sign : -sign;
}

/// In place. The chain has no part in given unknowns, nor in φ.
void BorderedChain::solve_once(std::span<double> x) const {
  couple(x, x, [](std::size_t, double) {});
  chain_->solve(x);
  if (system_.tangency() == nullptr) return;
  const double phi =
      static_cast<double>(x.back() - tangency_product(x)) / pivot_;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) x[i] -= phi * column_[i];
  x.back() = phi;
}

/// b less the product with x, each component as exact as if it was summed in
/// long double and rounded once.
void BorderedChain::residual(std::span<const double> b,
                             std::span<const double> x,
                             std::span<double> out) const {
  std::ranges::copy(b, out.begin());
  std::vector<std::pair<std::size_t, double>> lost;
  couple(x, out,
         [&](std::size_t row, double rest) { lost.emplace_back(row, rest); });
  chain_->subtract_product(x, out);
  for (const auto& [row, rest] : lost) out[row] += rest;
  const int unknowns = system_.num_unknowns();
  for (int i = 0; i < unknowns; ++i) {
    if (system_.given(i)) out[at(i)] = b[at(i)] - x[at(i)];
  }
  if (system_.tangency() == nullptr) return;
  const nlp::SparseVector& rates = system_.tangency()->fixed_rates();
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    const std::size_t i = at(rates.index[e]);
    out[i] = static_cast<double>(static_cast<long double>(b[i]) - x[i] +
                                 static_cast<long double>(rates.value[e]) *
                                     x.back());
  }
  out.back() = static_cast<double>(
      b.back() -
      (tangency_product(x) +
       static_cast<long double>(system_.tangency_row().by_parameter) *
           x.back()));
}

bool BorderedChain::solve(std::span<const double> b, std::span<double> x,
                          double enough) {
  const PhaseTimer timer(Phase::Solution);
  const auto largest = [](std::span<const double> values) {
    double max = 0.0;
    for (const double value : values) {
      max = std::abs(value) <= max ? max : std::abs(value);
    }
    return max;
  };
  // The condition may keep the residual of a rounded solution above what is
  // enough; then refinement does not help, and less must do.
  constexpr double kOfUse = 1e-2;
  constexpr int kRefinements = 4;
  std::ranges::copy(b, x.begin());
  solve_once(x);
  const double size = largest(b);
  std::vector<double> correction(x.size());
  double last = std::numeric_limits<double>::infinity();
  for (int refinement = 0;; ++refinement) {
    residual(b, x, correction);
    const double left = largest(correction);
    if (!std::isfinite(left)) return false;
    at_once_ = refinement == 0 && left <= enough * size;
    if (left <= enough * size) return true;
    if (left > 0.5 * last || refinement == kRefinements) {
      return left <= kOfUse * size;
    }
    solve_once(correction);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
    last = left;
  }
}

bool BorderedChain::solve_alike(std::span<const double> b, std::span<double> x,
                                double enough) {
  if (!at_once_) return solve(b, x, enough);
  const PhaseTimer timer(Phase::Solution);
  std::ranges::copy(b, x.begin());
  solve_once(x);
  return true;
}

}  // namespace brachisto
