// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/sparse_lu.hpp"

#include <algorithm>
#include <cstdint>
#include <new>
#include <numeric>

#include "brachisto/math/index.hpp"

namespace brachisto {

namespace {

constexpr int kRefinements = 2;

/// +1 for an even permutation, −1 for an odd one.
int parity(std::span<const int> permutation) {
  std::vector<char> seen(permutation.size());
  int sign = 1;
  for (std::size_t i = 0; i < permutation.size(); ++i) {
    // A cycle of even length is odd.
    for (std::size_t j = at(permutation[i]); j != i && seen[i] == 0;
         j = at(permutation[j])) {
      seen[j] = 1;
      sign = -sign;
    }
  }
  return sign;
}

/// The entries of `order` by ascending key, equal keys left in order, in linear
/// time.
template <class Key>
std::vector<int> sorted_by(const Key& key, int num_keys,
                           std::span<const int> order) {
  std::vector<int> place(at(num_keys) + 1, 0);
  for (const int entry : order) ++place[at(key(entry)) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<int> sorted(order.size());
  for (const int entry : order) sorted[at(place[at(key(entry))]++)] = entry;
  return sorted;
}

}  // namespace

SparseLu::SparseLu(const nlp::SparsityPattern& pattern,
                   const nlp::EliminationOrder& elimination)
    : size_(static_cast<int>(elimination.rows.size())),
      row_scale_(elimination.rows.size(), 1.0),
      slots_(pattern.num_entries()) {
  klu_defaults(&common_);
  common_.scale = 0;
  // Off the diagonal only where the diagonal is much smaller, within the band:
  // ten times, for with a hundred multipliers grow beyond what refinement mends
  // where an element of high degree has slopes that cancel.
  common_.tol = 0.1;
  // A power of two, so that scaling does not round.
  constexpr double kBorderScale = 0x1p-60;
  for (int i = size_ - elimination.border; i < size_; ++i) {
    row_scale_[at(elimination.rows[at(i)])] = kBorderScale;
  }
  // Sort entries by column, then row; equal positions share a slot.
  std::vector<int> order(pattern.num_entries());
  std::iota(order.begin(), order.end(), 0);
  const auto row_of = [&](int entry) { return pattern[at(entry)].row; };
  const auto col_of = [&](int entry) { return pattern[at(entry)].col; };
  order = sorted_by(row_of, size_, order);
  order = sorted_by(col_of, size_, order);
  column_starts_.assign(at(size_) + 1, 0);
  int column = -1;
  for (const int entry : order) {
    const auto [row, col] = pattern[at(entry)];
    if (col != column || rows_.back() != row) {
      rows_.push_back(row);
      ++column_starts_[at(col) + 1];
      column = col;
    }
    slots_[at(entry)] = static_cast<int>(rows_.size()) - 1;
  }
  std::partial_sum(column_starts_.begin(), column_starts_.end(),
                   column_starts_.begin());
  values_.resize(rows_.size());
  std::vector<int> row_order = elimination.rows;
  std::vector<int> column_order = elimination.columns;
  symbolic_ =
      klu_analyze_given(size_, column_starts_.data(), rows_.data(),
                        row_order.data(), column_order.data(), &common_);
  if (symbolic_ == nullptr) throw std::bad_alloc();
}

SparseLu::~SparseLu() {
  klu_free_numeric(&numeric_, &common_);
  klu_free_symbolic(&symbolic_, &common_);
}

bool SparseLu::factorise(std::span<const double> values) {
  std::fill(values_.begin(), values_.end(), 0.0);
  for (std::size_t e = 0; e < slots_.size(); ++e) {
    values_[at(slots_[e])] += values[e];
  }
  for (std::size_t e = 0; e < values_.size(); ++e) {
    values_[e] *= row_scale_[at(rows_[e])];
  }
  klu_free_numeric(&numeric_, &common_);
  numeric_ = klu_factor(column_starts_.data(), rows_.data(), values_.data(),
                        symbolic_, &common_);
  return numeric_ != nullptr && common_.status == KLU_OK;
}

int SparseLu::determinant_sign() const {
  if (numeric_ == nullptr || common_.status != KLU_OK) return 0;
  // P R A Q = L U with positive row scaling R and unit diagonal of L.
  int sign =
      parity({numeric_->Pnum, at(size_)}) * parity({symbolic_->Q, at(size_)});
  const auto* diagonal = static_cast<const double*>(numeric_->Udiag);
  for (int i = 0; i < size_; ++i) {
    if (diagonal[i] < 0.0) sign = -sign;
  }
  return sign;
}

std::vector<double> SparseLu::solve(std::span<const double> b) {
  std::vector<double> scaled(b.begin(), b.end());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] *= row_scale_[i];
  std::vector<double> y = scaled;
  klu_solve(symbolic_, numeric_, size_, 1, y.data(), &common_);

  for (int refinement = 0; refinement < kRefinements; ++refinement) {
    std::vector<long double> residual(scaled.begin(), scaled.end());
    for (int col = 0; col < size_; ++col) {
      for (int e = column_starts_[at(col)]; e < column_starts_[at(col) + 1];
           ++e) {
        residual[at(rows_[at(e)])] -=
            static_cast<long double>(values_[at(e)]) * y[at(col)];
      }
    }
    std::vector<double> correction(residual.begin(), residual.end());
    klu_solve(symbolic_, numeric_, size_, 1, correction.data(), &common_);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += correction[i];
  }
  return y;
}

}  // namespace brachisto
