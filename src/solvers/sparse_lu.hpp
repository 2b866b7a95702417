// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Sparse LU factorisation of a square matrix given by coordinates.

#pragma once

#include <klu.h>

#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto {

/// KLU with iterative refinement. The pattern is analysed once; the values of
/// repeated positions add up.
///
/// Orderings that minimise fill for the pattern alone fail on KKT matrices:
/// zero diagonals make the factorisation choose other pivots, and a dense
/// border row chosen early fills everything. So the order is given, and rows of
/// the border are scaled down until no other row is left.
class SparseLu {
 public:
  SparseLu(const nlp::SparsityPattern& pattern,
           const nlp::EliminationOrder& order);
  ~SparseLu();
  SparseLu(const SparseLu&) = delete;
  SparseLu& operator=(const SparseLu&) = delete;

  /// False if the matrix is singular to working precision.
  /// \param values  in the order of the pattern
  [[nodiscard]] bool factorise(std::span<const double> values);

  /// Sign of the determinant: +1 or −1, 0 if the last factorisation failed.
  [[nodiscard]] int determinant_sign() const;

  /// Most memory that KLU had at a time [bytes].
  [[nodiscard]] double peak_bytes() const {
    return static_cast<double>(common_.mempeak);
  }

  /// Solves A y = b with two steps of refinement, residuals in long double.
  [[nodiscard]] std::vector<double> solve(std::span<const double> b);

 private:
  int size_;
  klu_common common_;
  std::vector<double> row_scale_;
  std::vector<int> column_starts_, rows_;
  std::vector<int> slots_;  // entry of the pattern → place in values_
  std::vector<double> values_;
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

}  // namespace brachisto
