// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which unknowns belong to which block of a chain.

#pragma once

#include <span>
#include <vector>

#include "brachisto/nlp/problem.hpp"

namespace brachisto {

/// Joins links to longer ones until their interiors have about `join_to`
/// unknowns: separators within them turn interior.
void join_links(nlp::ChainStructure& chain, int join_to);

/// The unknowns of every block, as ranges of neighbours: a mesh has a few to an
/// element, however many unknowns that has.
class ChainBlocks {
 public:
  /// Unknowns first … first + count − 1.
  struct Range {
    int first, count;
  };

  explicit ChainBlocks(const nlp::ChainStructure& chain);

  [[nodiscard]] int num_links() const { return num_links_; }
  /// Without absent ones.
  [[nodiscard]] int num_unknowns() const { return num_unknowns_; }
  /// Of separator e ≤ num_links() for 2 e, of the interior of link e for
  /// 2 e + 1, by ascending number.
  [[nodiscard]] std::span<const Range> of(int block) const;
  /// Unknowns of the border, likewise.
  [[nodiscard]] const std::vector<int>& border() const { return border_; }

 private:
  int num_links_ = 0, num_unknowns_ = 0;
  std::vector<int> start_;  ///< of the ranges of a block
  std::vector<Range> ranges_;
  std::vector<int> border_;
};

}  // namespace brachisto
