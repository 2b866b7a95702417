// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Gauss's rules on [0, 1]; Lagrange polynomials through given nodes, and the
/// matrices that evaluate, differentiate and integrate them.

#pragma once

#include <span>
#include <vector>

namespace brachisto::math {

/// A quadrature rule on [0, 1].
struct QuadratureRule {
  std::vector<double> points;   ///< ascending
  std::vector<double> weights;  ///< sum to 1
};

/// Gauss–Legendre rule with `count` ≥ 1 points, exact for degree 2·count − 1.
/// Points and weights are right to the last bit or so: they are computed in
/// long double and rounded once.
[[nodiscard]] QuadratureRule gauss_legendre(int count);

/// The `count` ≥ 2 Gauss–Lobatto points on [0, 1], both ends among them: well
/// conditioned nodes for interpolation that neighbouring elements can share.
[[nodiscard]] std::vector<double> gauss_lobatto_points(int count);

/// Radau's rule with `count` ≥ 1 points, the last of them 1, exact for degree
/// 2·count − 2.
[[nodiscard]] QuadratureRule radau_right(int count);

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
  [[nodiscard]] std::span<double> row(int i) {
    return std::span(data_).subspan(index(i, 0),
                                    static_cast<std::size_t>(cols_));
  }
  [[nodiscard]] std::span<const double> row(int i) const {
    return std::span(data_).subspan(index(i, 0),
                                    static_cast<std::size_t>(cols_));
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
  /// 1/Π_{i≠j} (t_j − t_i): Σ_j weights()[j] f(t_j) is the leading coefficient
  /// of the polynomial through values f(t_j).
  [[nodiscard]] std::span<const double> weights() const { return weights_; }
  /// Π_j (t − t_j).
  [[nodiscard]] double node_polynomial(double t) const;

  /// values[j] = ℓ_j(t); at the nodes exactly 0, and 1 up to rounding. size()
  /// values, in O(size()).
  void evaluate(double t, std::span<double> values) const;
  /// With slopes[j] = ℓ_j'(t); also O(size()).
  void evaluate(double t, std::span<double> values,
                std::span<double> slopes) const;

  /// Row i holds ℓ_j(points[i]).
  [[nodiscard]] SmallMatrix values_at(std::span<const double> points) const;
  /// Row i holds ℓ_j'(points[i]). Every row sums to zero exactly, for that is
  /// the slope of a constant, however large.
  [[nodiscard]] SmallMatrix slopes_at(std::span<const double> points) const;
  /// Row i holds ∫ ℓ_j from 0 to ends[i], by a rule on [0, 1] that is exact for
  /// polynomials of their degree.
  [[nodiscard]] SmallMatrix integrals_to(std::span<const double> ends,
                                         const QuadratureRule& rule) const;

 private:
  std::vector<double> nodes_;
  std::vector<double> weights_;
};

}  // namespace brachisto::math
