// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a problem states about the block structure of its KKT matrix.

#pragma once

#include <vector>

namespace brachisto::nlp {

/// A symmetric matrix as a chain: links 0 … num_links − 1 in order, each with
/// unknowns of its own (its interior), neighbouring links joined by the
/// unknowns of a separator, and a border of few unknowns that couple with
/// everything:
///
///     separator 0 | interior 0 | separator 1 | interior 1 | … | separator N
///
/// Two unknowns may have a nonzero entry only if they belong to one link (its
/// interior and its two separators) or one of them to the border.
///
/// The unknowns of a KKT matrix are the variables, then the multipliers. Choose
/// as interior what is determined once the separators are known, states
/// together with the multipliers of the constraints that determine them: then
/// the block of the interior is regular, and all pivots can be found in it. The
/// multiplier of an inequality belongs into the interior of a link that has its
/// variables; the solver puts its slack beside it.
struct ChainStructure {
  static constexpr int kBorder = -1;  ///< the unknown couples with all links
  static constexpr int kAbsent = -2;  ///< the unknown is not in the matrix

  int num_links = 0;
  /// Of every unknown: 2 e for separator e ≤ num_links, 2 e + 1 for the
  /// interior of link e, or one of the constants above.
  std::vector<int> block;
  /// By what to multiply rows and columns of the unknowns so that no entry is
  /// much larger than others: powers of two, which change no digit, 1 for
  /// absent ones. Empty: ones.
  std::vector<double> scale = {};

  /// True where a problem states no such structure.
  [[nodiscard]] bool empty() const { return num_links == 0; }
};

}  // namespace brachisto::nlp
