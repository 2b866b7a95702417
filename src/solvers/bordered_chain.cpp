// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/bordered_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "brachisto/math/phase_clock.hpp"
#include "math/index.hpp"
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
    : system_(system),
      chain_(std::move(chain)),
      column_(at(system.size()), 0.0),
      wide_(at(system.size())),
      correction_(at(system.size())),
      reduced_(at(system.size())) {}

BorderedChain::~BorderedChain() = default;

/// rhs −= C v, v the given unknowns in x.
void BorderedChain::couple(std::span<const double> x,
                           std::span<long double> rhs) const {
  const std::array<std::span<const double>, 2> values = {system_.hess_lag(),
                                                         system_.jac_g()};
  for (const ChainMap::Coupling& c : chain_->couplings()) {
    rhs[at(c.unknown)] -=
        static_cast<long double>(values[at(c.array)][at(c.entry)]) *
        x[at(c.absent)];
  }
}

/// qᵀu + sᵀv of the vector (u, v).
long double BorderedChain::tangency_product(std::span<const double> x) const {
  const nlp::TangencyCondition::Linearisation& row = system_.tangency_row();
  const int n = system_.problem().num_variables();
  long double sum = 0.0L;
  const auto add = [&](const nlp::SparseVector& part, int offset) {
    for (std::size_t e = 0; e < part.index.size(); ++e) {
      sum += static_cast<long double>(part.value[e]) *
             x[at(offset + part.index[e])];
    }
  };
  add(row.by_x, 0);
  add(row.by_lambda, n);
  return sum;
}

bool BorderedChain::factorise() {
  const PhaseTimer timer(Phase::Factorisation);
  const std::array<std::span<const double>, 2> values = {system_.hess_lag(),
                                                         system_.jac_g()};
  pivot_ = 0.0;
  if (!chain_->factorise(values) || chain_->inertia().zero > 0) return false;
  pivot_ = 1.0;
  if (system_.tangency() == nullptr) return true;
  std::fill(column_.begin(), column_.end(), 0.0);
  const nlp::SparseVector& rates = system_.tangency()->fixed_rates();
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    column_[at(rates.index[e])] = -rates.value[e];
  }
  std::fill(wide_.begin(), wide_.end(), 0.0L);
  couple(column_, wide_);
  for (std::size_t i = 0; i < wide_.size(); ++i) {
    reduced_[i] = static_cast<double>(wide_[i]);
  }
  chain_->solve(reduced_);
  for (int i = 0; i < system_.num_unknowns(); ++i) {
    if (!system_.given(i)) column_[at(i)] = reduced_[at(i)];
  }
  pivot_ = static_cast<double>(system_.tangency_row().by_parameter -
                               tangency_product(column_));
  return std::isfinite(pivot_) && pivot_ != 0.0;
}

void BorderedChain::forget_pivots() {
  chain_->forget_pivots();
}

int BorderedChain::determinant_sign() const {
  if (pivot_ == 0.0 || !std::isfinite(pivot_)) return 0;
  const int sign = chain_->inertia().negative % 2 == 0 ? 1 : -1;
  return pivot_ > 0.0 ? sign : -sign;
}

void BorderedChain::solve_once(std::span<const double> b, std::span<double> x) {
  std::copy(b.begin(), b.end(), wide_.begin());
  couple(b, wide_);
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = static_cast<double>(wide_[i]);
  }
  const int unknowns = system_.num_unknowns();
  for (int i = 0; i < unknowns; ++i) {
    if (system_.given(i)) x[at(i)] = b[at(i)];
  }
  chain_->solve(x);
  if (system_.tangency() == nullptr) return;
  const double phi =
      static_cast<double>(b.back() - tangency_product(x)) / pivot_;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) x[i] -= phi * column_[i];
  x.back() = phi;
}

void BorderedChain::residual(std::span<const double> b,
                             std::span<const double> x,
                             std::span<long double> out) const {
  std::copy(b.begin(), b.end(), out.begin());
  chain_->subtract_product(x, out);
  couple(x, out);
  const int unknowns = system_.num_unknowns();
  for (int i = 0; i < unknowns; ++i) {
    if (system_.given(i)) out[at(i)] -= x[at(i)];
  }
  if (system_.tangency() == nullptr) return;
  const nlp::SparseVector& rates = system_.tangency()->fixed_rates();
  for (std::size_t e = 0; e < rates.index.size(); ++e) {
    out[at(rates.index[e])] +=
        static_cast<long double>(rates.value[e]) * x.back();
  }
  out.back() -=
      tangency_product(x) +
      static_cast<long double>(system_.tangency_row().by_parameter) * x.back();
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
  solve_once(b, x);
  const double size = largest(b);
  double last = std::numeric_limits<double>::infinity();
  for (int refinement = 0;; ++refinement) {
    residual(b, x, wide_);
    for (std::size_t i = 0; i < wide_.size(); ++i) {
      reduced_[i] = static_cast<double>(wide_[i]);
    }
    const double left = largest(reduced_);
    if (!std::isfinite(left)) return false;
    if (left <= enough * size) return true;
    if (left > 0.5 * last || refinement == kRefinements) {
      return left <= kOfUse * size;
    }
    solve_once(reduced_, correction_);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction_[i];
    last = left;
  }
}

}  // namespace brachisto
