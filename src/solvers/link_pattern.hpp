// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Which entries of the matrix of a link differ from zero.

#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace brachisto {

/// The pattern of a symmetric matrix whose first `interior` unknowns are to be
/// eliminated: a bit to each entry of the lower triangle.
struct LinkPattern {
  int size = 0, interior = 0;
  std::vector<std::uint64_t> bits;

  LinkPattern() = default;
  LinkPattern(int num_unknowns, int num_interior)
      : size(num_unknowns), interior(num_interior) {
    bits.resize(place(size, 0) / kBits + 1);
  }

  void set(int i, int j) {
    const std::size_t k = place(i, j);
    bits[k / kBits] |= std::uint64_t{1} << (k % kBits);
  }
  [[nodiscard]] bool has(int i, int j) const {
    const std::size_t k = place(i, j);
    return ((bits[k / kBits] >> (k % kBits)) & 1U) != 0;
  }
  /// Entries that only one of two patterns of the same size has.
  [[nodiscard]] int num_different(const LinkPattern& other) const {
    int sum = 0;
    for (std::size_t k = 0; k < bits.size(); ++k) {
      sum += std::popcount(bits[k] ^ other.bits[k]);
    }
    return sum;
  }
  bool operator==(const LinkPattern&) const = default;

 private:
  static constexpr std::size_t kBits = 64;
  static std::size_t place(int i, int j) {
    if (i < j) std::swap(i, j);
    const auto row = static_cast<std::size_t>(i);
    return row * (row + 1) / 2 + static_cast<std::size_t>(j);
  }
};

}  // namespace brachisto
