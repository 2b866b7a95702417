// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sparse matrix from the stencil that makes it.

#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "brachisto/math/stop_condition.hpp"
#include "brachisto/nlp/sparsity_pattern.hpp"

namespace brachisto {

/// Receives the entries of a sparse matrix from the stencil that makes them,
/// always in the same order: where they stand, or their values, so that pattern
/// and values cannot drift apart.
class Entries {
 public:
  explicit Entries(nlp::SparsityPattern& pattern) : pattern_(&pattern) {}
  explicit Entries(std::span<double> values) : next_(values.data()) {}

  void operator()(int row, int col, double value) {
    if (next_ != nullptr) {
      *next_++ = value;
    } else {
      pattern_->add(row, col);
    }
  }

  /// factor · shares[i] in a row, at columns `stride` apart.
  void row(int row, int col, int stride, std::span<const double> shares,
           double factor = 1.0) {
    if (put_values(shares, factor)) return;
    for (std::size_t i = 0; i < shares.size(); ++i, col += stride) {
      pattern_->add(row, col);
    }
  }
  /// The same of a symmetric matrix, below the diagonal, whichever of the two
  /// the row is.
  void lower(int one, int other, int stride, std::span<const double> shares,
             double factor = 1.0) {
    if (put_values(shares, factor)) return;
    for (std::size_t i = 0; i < shares.size(); ++i, other += stride) {
      pattern_->add(std::max(one, other), std::min(one, other));
    }
  }

  /// Calls put_one(i) for i from `begin` to before `end`, elements or pieces.
  /// Each but the first has the entries of the one before, every row and every
  /// column farther on by a constant of its own: of positions three are asked.
  template <class PutOne>
  void each(int begin, int end, PutOne&& put_one);

 private:
  /// False where positions are asked for.
  bool put_values(std::span<const double> shares, double factor) {
    if (next_ == nullptr) return false;
    for (std::size_t i = 0; i < shares.size(); ++i) {
      next_[i] = factor * shares[i];
    }
    next_ += shares.size();
    return true;
  }

  double* next_ = nullptr;
  nlp::SparsityPattern* pattern_ = nullptr;
};

template <class PutOne>
void Entries::each(int begin, int end, PutOne&& put_one) {
  constexpr int kAsked = 3;
  const bool all = pattern_ == nullptr || end - begin <= kAsked;
  const int last = all ? end : begin + kAsked;
  std::size_t before_last = 0;
  for (int i = begin; i < last; ++i) {
    check_stop(i);
    if (!all) before_last = pattern_->num_entries();
    put_one(i);
  }
  if (all) return;
  pattern_->repeat(pattern_->num_entries() - before_last,
                   static_cast<std::size_t>(end - last));
}

}  // namespace brachisto
