// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/polynomial_basis.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

#include "brachisto/math/index.hpp"

namespace brachisto::math {

namespace {

/// What rounding leaves of the sum of a row would be multiplied by values of
/// any size, on element after element to the same side. The smallest entry,
/// whose last digit is the finest, takes it.
void sum_to_zero(std::span<double> row) {
  double& smallest = *std::min_element(
      row.begin(), row.end(),
      [](double a, double b) { return std::abs(a) < std::abs(b); });
  smallest = 0.0;
  smallest =
      static_cast<double>(-std::accumulate(row.begin(), row.end(), 0.0L));
}

}  // namespace

LagrangeBasis::LagrangeBasis(std::vector<double> nodes)
    : nodes_(std::move(nodes)), weights_(nodes_.size()) {
  for (int j = 0; j < size(); ++j) {
    double product = 1.0;
    for (int i = 0; i < size(); ++i) {
      if (i != j) product *= nodes_[at(j)] - nodes_[at(i)];
    }
    weights_[at(j)] = 1.0 / product;
  }
}

// ℓ_j = w_j Π_{i<j} (t − t_i) Π_{i>j} (t − t_i), the products gathered from
// both ends: no quotient, so that a node is no special case, and every factor
// enters as in the definition, rounded once.
void LagrangeBasis::evaluate(double t, std::span<double> values) const {
  assert(values.size() == nodes_.size());
  double before = 1.0;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    values[j] = weights_[j] * before;
    before *= t - nodes_[j];
  }
  double behind = 1.0;
  for (std::size_t j = nodes_.size(); j-- > 0;) {
    values[j] *= behind;
    behind *= t - nodes_[j];
  }
}

// The same with the derivatives of both products.
void LagrangeBasis::evaluate(double t, std::span<double> values,
                             std::span<double> slopes) const {
  assert(values.size() == nodes_.size());
  assert(slopes.size() == nodes_.size());
  double before = 1.0, before_slope = 0.0;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    values[j] = weights_[j] * before;
    slopes[j] = weights_[j] * before_slope;
    before_slope = before_slope * (t - nodes_[j]) + before;
    before *= t - nodes_[j];
  }
  double behind = 1.0, behind_slope = 0.0;
  for (std::size_t j = nodes_.size(); j-- > 0;) {
    slopes[j] = slopes[j] * behind + values[j] * behind_slope;
    values[j] *= behind;
    behind_slope = behind_slope * (t - nodes_[j]) + behind;
    behind *= t - nodes_[j];
  }
}

double LagrangeBasis::node_polynomial(double t) const {
  double product = 1.0;
  for (const double node : nodes_) product *= t - node;
  return product;
}

SmallMatrix LagrangeBasis::values_at(std::span<const double> points) const {
  SmallMatrix matrix(static_cast<int>(points.size()), size());
  for (int i = 0; i < matrix.rows(); ++i)
    evaluate(points[at(i)], matrix.row(i));
  return matrix;
}

SmallMatrix LagrangeBasis::slopes_at(std::span<const double> points) const {
  SmallMatrix matrix(static_cast<int>(points.size()), size());
  std::vector<double> values(nodes_.size());
  for (int i = 0; i < matrix.rows(); ++i) {
    evaluate(points[at(i)], values, matrix.row(i));
    sum_to_zero(matrix.row(i));
  }
  return matrix;
}

SmallMatrix LagrangeBasis::integrals_to(std::span<const double> ends,
                                        const QuadratureRule& rule) const {
  SmallMatrix matrix(static_cast<int>(ends.size()), size());
  std::vector<double> values(nodes_.size());
  for (int i = 0; i < matrix.rows(); ++i) {
    const double end = ends[at(i)];
    for (std::size_t q = 0; q < rule.points.size(); ++q) {
      evaluate(end * rule.points[q], values);
      for (int j = 0; j < size(); ++j) {
        matrix(i, j) += end * rule.weights[q] * values[at(j)];
      }
    }
  }
  return matrix;
}

}  // namespace brachisto::math
