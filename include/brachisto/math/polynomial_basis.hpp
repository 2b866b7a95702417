// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Lagrange polynomials through given nodes, and the matrices that evaluate,
/// differentiate and integrate them.

#pragma once

#include <span>
#include <vector>

#include "brachisto/math/gauss.hpp"

namespace brachisto::math {

/// A small dense matrix in row-major order, fixed after construction.
class SmallMatrix {
 public:
  SmallMatrix() = default;
  SmallMatrix(int rows, int cols)
      : rows_(rows),
        cols_(cols),
        data_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols)) {
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] int cols() const { return cols_; }
  [[nodiscard]] double operator()(int i, int j) const {
    return data_[index(i, j)];
  }
  double& operator()(int i, int j) { return data_[index(i, j)]; }

 private:
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(cols_) +
           static_cast<std::size_t>(j);
  }
  int rows_ = 0;
  int cols_ = 0;
  std::vector<double> data_;
};

/// The Lagrange basis ℓ_0 … ℓ_p of p + 1 distinct nodes.
class LagrangeBasis {
 public:
  explicit LagrangeBasis(std::vector<double> nodes);

  [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
  [[nodiscard]] std::span<const double> nodes() const { return nodes_; }

  /// values[j] = ℓ_j(t); at the nodes exactly 0, and 1 up to rounding. size()
  /// values.
  void evaluate(double t, std::span<double> values) const;
  /// slopes[j] = ℓ_j'(t); size() values.
  void differentiate(double t, std::span<double> slopes) const;

  /// Row i holds ℓ_j(points[i]).
  [[nodiscard]] SmallMatrix values_at(std::span<const double> points) const {
    return rows(points, &LagrangeBasis::evaluate);
  }
  /// Row i holds ℓ_j'(points[i]).
  [[nodiscard]] SmallMatrix slopes_at(std::span<const double> points) const {
    return rows(points, &LagrangeBasis::differentiate);
  }
  /// Row i holds ∫ ℓ_j from 0 to ends[i], by a rule on [0, 1] that is exact for
  /// polynomials of their degree.
  [[nodiscard]] SmallMatrix integrals_to(std::span<const double> ends,
                                         const QuadratureRule& rule) const;

 private:
  [[nodiscard]] SmallMatrix rows(
      std::span<const double> points,
      void (LagrangeBasis::*row_at)(double, std::span<double>) const) const;
  std::vector<double> nodes_;
  std::vector<double> weights_;  // 1 / Π_{i≠j} (t_j − t_i)
};

}  // namespace brachisto::math
