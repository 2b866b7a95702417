// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Matrices that are chains, with their dense counterparts.

#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/inertia.hpp"
#include "support/random_points.hpp"

namespace brachisto::testing {

/// Unit roundoff.
inline constexpr double kRoundoff =
    0.5 * std::numeric_limits<double>::epsilon();

/// A symmetric matrix by coordinates.
struct ChainEntries {
  nlp::ChainStructure structure;
  std::vector<int> rows, cols;
  std::vector<double> values;

  [[nodiscard]] int size() const {
    return static_cast<int>(structure.block.size());
  }
  void add(int row, int col, double value) {
    rows.push_back(row);
    cols.push_back(col);
    values.push_back(value);
  }
  [[nodiscard]] nlp::SparsityPattern positions() const {
    nlp::SparsityPattern pattern;
    for (std::size_t e = 0; e < rows.size(); ++e) pattern.add(rows[e], cols[e]);
    return pattern;
  }
  [[nodiscard]] std::unique_ptr<ChainLdlt> analysed() const {
    const nlp::SparsityPattern pattern = positions();
    const std::array<EntryPositions, 1> arrays = {EntryPositions{pattern, 0}};
    return ChainLdlt::make(structure, arrays);
  }
  [[nodiscard]] bool factorise(ChainLdlt& ldlt) const {
    const std::array<std::span<const double>, 1> arrays = {values};
    return ldlt.factorise(arrays);
  }
};

/// The same, and dense.
struct ChainMatrix : ChainEntries {
  Eigen::MatrixXd dense;

  void add(int row, int col, double value) {
    ChainEntries::add(row, col, value);
    dense(row, col) += value;
    if (row != col) dense(col, row) += value;
  }
};

/// Unknowns of `links` links by block: separators of `separator` unknowns,
/// interiors of `interior`, `border` at the end.
[[nodiscard]] inline ChainMatrix empty_chain(int links, int interior,
                                             int separator, int border) {
  ChainMatrix out;
  out.structure.num_links = links;
  const int per_link = separator + interior;
  const int last = links * per_link + separator;
  out.structure.block.resize(static_cast<std::size_t>(last + border));
  for (int i = 0; i < last + border; ++i) {
    int block = nlp::ChainStructure::kBorder;
    if (i < last) {
      const int link = i / std::max(1, per_link);
      block = 2 * link + (i % per_link < separator ? 0 : 1);
    }
    out.structure.block[static_cast<std::size_t>(i)] = block;
  }
  out.dense = Eigen::MatrixXd::Zero(out.size(), out.size());
  return out;
}

/// True where the structure allows an entry.
[[nodiscard]] inline bool coupled(const nlp::ChainStructure& chain, int i,
                                  int j) {
  const auto block = [&](int k) {
    return chain.block[static_cast<std::size_t>(k)];
  };
  const int low = std::min(block(i), block(j));
  const int high = std::max(block(i), block(j));
  return low < 0 || low == high || high <= 2 * (low / 2) + 2;
}

/// Calls visit(i, j), i ≥ j, for every entry the structure allows.
template <class Visit>
void for_each_coupled(const ChainMatrix& matrix, Visit&& visit) {
  for (int j = 0; j < matrix.size(); ++j) {
    for (int i = j; i < matrix.size(); ++i) {
      if (coupled(matrix.structure, i, j)) visit(i, j);
    }
  }
}

/// Eigenvalues by sign; `zero` bounds those that count as zero.
[[nodiscard]] inline Inertia by_eigenvalues(const Eigen::MatrixXd& A,
                                            double zero) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      A, Eigen::EigenvaluesOnly);
  Inertia out{.known = true};
  for (const double value : solver.eigenvalues()) {
    if (value > zero) ++out.positive;
    if (value < -zero) ++out.negative;
    if (std::abs(value) <= zero) ++out.zero;
  }
  return out;
}

/// ‖b − A x‖ / (‖A‖ ‖x‖ + ‖b‖) in the maximum norm, the residual in long
/// double: by how much A and b have to be changed for x to be exact (Rigal and
/// Gaches 1967).
[[nodiscard]] inline double backward_error(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& x,
                                           const Eigen::VectorXd& b) {
  long double worst = 0.0L;
  double norm = 0.0;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    long double sum = b(i);
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      sum -= static_cast<long double>(A(i, j)) * x(j);
    }
    worst = std::max(worst, std::abs(sum));
    norm = std::max(norm, A.row(i).cwiseAbs().sum());
  }
  return static_cast<double>(worst) /
         (norm * x.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

/// [H Jᵀ; J −δ] within each link: half of each block are multipliers.
[[nodiscard]] inline ChainMatrix random_saddle(std::uint32_t seed, int links,
                                               int interior, int separator,
                                               int border, double delta = 0.0) {
  Random random(seed);
  ChainMatrix matrix = empty_chain(links, interior, separator, border);
  const int last = matrix.size() - border;
  for_each_coupled(matrix, [&](int i, int j) {
    const bool multipliers = i < last && i % 2 == 1 && j % 2 == 1;
    if (!multipliers) matrix.add(i, j, random.uniform(-1.0, 1.0));
    if (multipliers && i == j) matrix.add(i, j, -delta);
  });
  return matrix;
}

}  // namespace brachisto::testing
