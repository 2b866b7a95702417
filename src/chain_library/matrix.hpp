// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A symmetric matrix of which nothing is known but its entries.

#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "brachisto/nlp/problem.hpp"
#include "solvers/chain_ldlt.hpp"
#include "solvers/mumps.hpp"

namespace brachisto::chain_library {

/// Factorised along the chain that is found in it, or by MUMPS if there is none
/// and BRACHISTO_CHAIN_FALLBACK=mumps is in the environment.
///
/// The chain is looked for when there are values: a pattern alone does not tell
/// multipliers of equations from variables.
class Matrix {
 public:
  /// \param pattern  of one triangle
  Matrix(int size, nlp::SparsityPattern pattern)
      : size_(size), pattern_(std::move(pattern)) {}

  /// Of a matrix that is singular the inertia says so. Unknown if the matrix
  /// is no chain, which is told.
  ///
  /// \param values   of the entries, in the pattern's order
  /// \param quality  a new one makes pivots be chosen anew
  [[nodiscard]] Inertia factorise(std::span<const double> values,
                                  double quality = 0.0);
  [[nodiscard]] bool factorised() const { return ldlt_ || mumps_; }
  /// Replaces the right side by the solution.
  /// \pre factorised()
  void solve(std::span<double> x) const;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::size_t num_entries() const {
    return pattern_.num_entries();
  }

 private:
  bool find(std::span<const double> values);
  [[nodiscard]] std::vector<double> scale_of(
      std::span<const double> values) const;
  [[nodiscard]] Inertia factorise_by_mumps(std::span<const double> values);

  int size_;
  double quality_ = 0.0;
  nlp::SparsityPattern pattern_;
  std::unique_ptr<ChainLdlt> ldlt_;
  std::unique_ptr<Mumps> mumps_;
};

/// To stderr, each sentence once in a process.
void say_once(const std::string& what);

}  // namespace brachisto::chain_library
