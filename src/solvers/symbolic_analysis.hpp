// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Symbolic analysis: in what order to eliminate the interior of a link, and the
// sparsity that results, once for all links that look alike.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solvers/link_pattern.hpp"

namespace brachisto {

/// Sequence of pivots for a symmetric matrix whose first `interior` unknowns
/// are eliminated, with the sparsity that results. Entries of the matrix, its
/// factor and the Schur complement live in numbered slots.
///
/// Slot 0 always holds zero.
struct SymbolicAnalysis {
  /// Single: d. Pair: [d_pp d_pq; d_pq d_qq]. Saddle: the same with d_qq = 0,
  /// where p's column needs to be full only where q's is.
  enum class Kind { Single, Pair, Saddle };

  struct Row {
    int unknown = 0;
    int in_p = 0, in_q = 0;  ///< slots in the columns of p and q; 0: none
    int diagonal = 0;        ///< Saddle: slot of (unknown, unknown); 0: none
  };
  struct Pivot {
    Kind kind = Kind::Single;
    int p = 0, q = 0;
    int d_pp = 0, d_pq = 0, d_qq = 0;  ///< slots
    int rows_begin = 0, rows_end = 0;
    int q_rows_end = 0;  ///< Saddle: rows up to here have an entry in q
    int targets_begin = 0;
  };
  struct SchurEntry {
    int row = 0, col = 0;  ///< local unknowns ≥ interior, row ≥ col
    int slot = 0;
  };

  int size = 0, interior = 0;
  int num_slots = 1;
  int num_factor_slots = 1;  ///< slots from here on are the Schur complement's
  std::vector<Pivot> pivots;
  std::vector<Row> rows;
  /// Slots that take the products of a pivot's rows, in the order in which the
  /// numeric factorisation visits them.
  std::vector<int> targets;
  std::vector<SchurEntry> schur;
  std::vector<int> slot_of;  ///< of (i, j) at i + size j; 0: always zero

  [[nodiscard]] int slot(int i, int j) const {
    return slot_of[static_cast<std::size_t>(i) +
                   static_cast<std::size_t>(size) *
                       static_cast<std::size_t>(j)];
  }

  static constexpr int kMaxSize = 4096;

  /// Chooses pivots on one matrix: among those whose multipliers stay small
  /// the one with the fewest operations (Markowitz), then the next. 2×2 pivots
  /// join an unknown to the multiplier of its equation, as pivots [h j; j 0].
  ///
  /// \param pattern  zeros in it are taken to be zeros of every matrix that is
  ///                 factorised
  /// \param matrix   size × size, symmetric and full
  /// \return nothing if size > kMaxSize, no stable sequence exists, or it
  ///         fills up
  [[nodiscard]] static std::optional<SymbolicAnalysis> make(
      const LinkPattern& pattern, std::span<const double> matrix);

  /// The same pivots in the same order for another pattern, with other unknowns
  /// around the interior. Nothing if one of them is none there.
  [[nodiscard]] std::optional<SymbolicAnalysis> moved_to(
      const LinkPattern& pattern) const;
};

}  // namespace brachisto
