// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/polynomial_basis.hpp"

#include <cassert>
#include <utility>

#include "math/index.hpp"

namespace brachisto::math {

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

// Products of differences rather than the barycentric quotient: for the dozen
// nodes in use it is as stable, and it needs no special case at a node.
void LagrangeBasis::evaluate(double t, std::span<double> values) const {
  assert(values.size() == nodes_.size());
  for (int j = 0; j < size(); ++j) {
    double product = weights_[at(j)];
    for (int i = 0; i < size(); ++i) {
      if (i != j) product *= t - nodes_[at(i)];
    }
    values[at(j)] = product;
  }
}

void LagrangeBasis::differentiate(double t, std::span<double> slopes) const {
  assert(slopes.size() == nodes_.size());
  for (int j = 0; j < size(); ++j) {
    double sum = 0.0;
    for (int skip = 0; skip < size(); ++skip) {
      if (skip == j) continue;
      double product = 1.0;
      for (int i = 0; i < size(); ++i) {
        if (i != j && i != skip) product *= t - nodes_[at(i)];
      }
      sum += product;
    }
    slopes[at(j)] = weights_[at(j)] * sum;
  }
}

SmallMatrix LagrangeBasis::rows(std::span<const double> points,
                                void (LagrangeBasis::*row_at)(double,
                                                              std::span<double>)
                                    const) const {
  SmallMatrix matrix(static_cast<int>(points.size()), size());
  std::vector<double> row(nodes_.size());
  for (int i = 0; i < matrix.rows(); ++i) {
    (this->*row_at)(points[at(i)], row);
    for (int j = 0; j < size(); ++j) matrix(i, j) = row[at(j)];
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
