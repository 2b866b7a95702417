// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Small sets of small numbers.

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "brachisto/math/index.hpp"

namespace brachisto {

/// A set of numbers below 64 kWords, a bit to each.
template <int kWords>
class BitSet {
 public:
  void set(int i) { word(i) |= bit(i); }
  void reset(int i) { word(i) &= ~bit(i); }
  [[nodiscard]] bool operator[](int i) const {
    return (words_[at(i) / kBits] & bit(i)) != 0;
  }
  [[nodiscard]] bool none() const {
    return std::ranges::all_of(words_, [](auto word) { return word == 0; });
  }
  [[nodiscard]] int count() const {
    int sum = 0;
    for (const std::uint64_t word : words_) sum += std::popcount(word);
    return sum;
  }
  BitSet& operator|=(const BitSet& other) {
    for (std::size_t w = 0; w < kWords; ++w) words_[w] |= other.words_[w];
    return *this;
  }
  BitSet& operator&=(const BitSet& other) {
    for (std::size_t w = 0; w < kWords; ++w) words_[w] &= other.words_[w];
    return *this;
  }
  friend BitSet operator|(BitSet a, const BitSet& b) { return a |= b; }
  friend BitSet operator&(BitSet a, const BitSet& b) { return a &= b; }
  [[nodiscard]] BitSet without(const BitSet& other) const {
    BitSet out = *this;
    for (std::size_t w = 0; w < kWords; ++w) out.words_[w] &= ~other.words_[w];
    return out;
  }
  /// visit(i) in ascending order.
  template <class Visit>
  void for_each(Visit&& visit) const {
    for (int w = 0; w < kWords; ++w) {
      for (std::uint64_t left = words_[at(w)]; left != 0; left &= left - 1) {
        visit(w * kBits + std::countr_zero(left));
      }
    }
  }

 private:
  static constexpr int kBits = 64;
  static std::uint64_t bit(int i) {
    return std::uint64_t{1} << (at(i) % kBits);
  }
  std::uint64_t& word(int i) { return words_[at(i) / kBits]; }

  std::array<std::uint64_t, kWords> words_{};
};

}  // namespace brachisto
