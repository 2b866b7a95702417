// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Partial factorisation of small dense symmetric matrices with threshold
// pivoting: the part of a multifrontal method that works on one front.

#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "solvers/arena.hpp"

namespace brachisto {

/// Fronts in the order of their elimination, and their factors.
class FrontStack {
 public:
  /// A front under assembly: unknowns and the full symmetric matrix.
  struct Front {
    std::vector<int> unknowns;
    std::vector<double> values;  ///< column by column
    int candidates = 0;          ///< the first so many may be eliminated

    void reset(std::size_t size) {
      unknowns.resize(size);
      values.assign(size * size, 0.0);
    }
    [[nodiscard]] int size() const { return static_cast<int>(unknowns.size()); }
    double& at(int i, int j) {
      return values[static_cast<std::size_t>(i) +
                    unknowns.size() * static_cast<std::size_t>(j)];
    }
  };

  /// How to choose pivots.
  struct Rule {
    /// A candidate whose column is no larger is a null vector.
    double zero = 0.0;
    /// Whether to take the best pivot there is where none keeps to the
    /// threshold; else the candidates left are for a later front.
    bool complete = false;
    /// A pivot d is taken if its multipliers, those of 2×2 pivots likewise, are
    /// at most 1/threshold (Duff and Reid).
    double threshold = 0.1;
  };

  void clear();

  /// Eliminates what it can. The front is left with the unknowns that were not
  /// eliminated, candidates first, and their Schur complement.
  void eliminate(Front& front, const Rule& rule);

  [[nodiscard]] int negative() const { return negative_; }
  [[nodiscard]] int zero() const { return zero_; }
  /// Entries of fronts, each as often as there was a pivot, times the share of
  /// the columns that were left that it changed.
  [[nodiscard]] double updates() const { return updates_; }

  /// L D y = b, then Lᵀ x = y, in place over all fronts.
  void forward(std::span<double> x) const;
  void backward(std::span<double> x) const;

 private:
  struct Record {
    double* values = nullptr;  ///< the lower trapezoid, column by column
    std::size_t rows = 0;
    int size = 0, eliminated = 0;
    [[nodiscard]] std::size_t num_values() const {
      const std::size_t k = static_cast<std::size_t>(eliminated);
      return k * static_cast<std::size_t>(size) - k * (k - 1) / 2;
    }
  };
  enum class Width : char { Single, Pair };

  bool choose(Front& front, int k, const Rule& rule, int& next, Width& width);
  void step(Front& front, int k, Width width);

  std::vector<Record> records_;
  std::vector<Width> widths_;
  std::vector<int> rows_;
  Arena<double> values_;
  std::vector<double> local_l_, local_m_;
  mutable std::vector<double> local_;
  int negative_ = 0, zero_ = 0;
  double updates_ = 0.0;
};

}  // namespace brachisto
