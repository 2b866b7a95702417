// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Memory that is taken piece by piece and given back as a whole.

#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace brachisto {

/// Pieces stay where they are until clear(), which keeps the memory.
template <class Value>
class Arena {
 public:
  /// Room for so many values, not initialised; the same again until keep().
  [[nodiscard]] Value* top(std::size_t size) {
    while (block_ < blocks_.size() && used_ + size > blocks_[block_].size) {
      ++block_;
      used_ = 0;
    }
    if (block_ == blocks_.size()) blocks_.push_back(block(size));
    return blocks_[block_].values.get() + used_;
  }
  /// Takes the first `size` values of the room handed out last.
  void keep(std::size_t size) { used_ += size; }
  void clear() { block_ = used_ = 0; }

 private:
  struct Block {
    std::unique_ptr<Value[]> values;
    std::size_t size;
  };
  /// Small at first, for many matrices are.
  [[nodiscard]] Block block(std::size_t size) const {
    constexpr std::size_t kSmall = (std::size_t{1} << 16U) / sizeof(Value);
    constexpr std::size_t kLarge = (std::size_t{1} << 20U) / sizeof(Value);
    size = std::max(size, blocks_.size() < 4 ? kSmall : kLarge);
    return {std::make_unique_for_overwrite<Value[]>(size), size};
  }

  std::vector<Block> blocks_;
  std::size_t block_ = 0, used_ = 0;
};

}  // namespace brachisto
