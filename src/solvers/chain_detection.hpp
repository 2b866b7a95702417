// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The chain in the bare pattern of a symmetric matrix.

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto {

/// Who has an entry with whom, the diagonal apart: the neighbours of i are
/// neighbour[start[i]] … neighbour[start[i + 1] − 1], each of them once.
struct MatrixGraph {
  std::vector<int> start, neighbour;

  [[nodiscard]] int size() const { return static_cast<int>(start.size()) - 1; }
  [[nodiscard]] std::span<const int> of(int unknown) const;

  /// Of one triangle or both.
  [[nodiscard]] static MatrixGraph of_pattern(
      int size, const nlp::SparsityPattern& pattern);
};

/// Unknowns with far more neighbours than most are the border: ten times the
/// mean, or if that shows no chain five or three times, and more than 32. The
/// others are
/// sorted by their distance from one at an end of the graph; between
/// neighbouring distances the smallest set is found that separates what comes
/// before from what comes behind (Kőnig), and the small ones of these sets are
/// the separators. What is between them can only be eliminated if each of its
/// unknowns without a diagonal entry has a neighbour to itself (a maximum
/// matching); the others go to the separator behind them.
///
/// \param no_diagonal  whether the diagonal entry of an unknown is 0, as that
///                     of the multiplier of an equation
/// \return nothing if there are fewer than four links, or some so large that a
///         chain is not the way to see the matrix
[[nodiscard]] std::optional<nlp::ChainStructure> find_chain(
    const MatrixGraph& graph, const std::vector<bool>& no_diagonal);

}  // namespace brachisto
