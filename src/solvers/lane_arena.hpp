// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Memory for lanes that is taken piece by piece and given back as a whole.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "solvers/numeric_factorisation.hpp"

namespace brachisto {

/// Pieces stay where they are until clear(), which keeps the memory.
class LaneArena {
 public:
  /// Room for `size` lanes, the same again until keep().
  [[nodiscard]] Lanes* top(std::size_t size) {
    while (block_ < blocks_.size() && used_ + size > blocks_[block_].size) {
      ++block_;
      used_ = 0;
    }
    if (block_ == blocks_.size()) blocks_.push_back(block(size));
    return blocks_[block_].lanes.get() + used_;
  }
  /// Takes the first `size` lanes of the room handed out last.
  void keep(std::size_t size) { used_ += size; }
  void clear() { block_ = used_ = 0; }

 private:
  struct Block {
    std::unique_ptr<Lanes[]> lanes;
    std::size_t size;
  };
  /// Small at first, for many matrices are.
  [[nodiscard]] Block block(std::size_t size) const {
    constexpr std::size_t kSmall = std::size_t{1} << 10U;
    constexpr std::size_t kLarge = std::size_t{1} << 14U;
    size = std::max(size, blocks_.size() < 4 ? kSmall : kLarge);
    return {std::make_unique_for_overwrite<Lanes[]>(size), size};
  }

  std::vector<Block> blocks_;
  std::size_t block_ = 0, used_ = 0;
};

}  // namespace brachisto
