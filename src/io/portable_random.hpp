// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random numbers that are the same everywhere.

#pragma once

#include <cstdint>
#include <string_view>

namespace brachisto::io {

/// Finaliser of splitmix64 (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t scrambled(std::uint64_t x) {
  x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31U);
}

/// FNV-1a hash of a text.
[[nodiscard]] constexpr std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  }
  return hash;
}

/// Uniform numbers that belong to a seed and a name, by counting: each depends
/// on its index alone, not on how many are drawn or what else is. They are the
/// outputs of splitmix64, started at a state scrambled from seed and name.
class RandomStream {
 public:
  /// A draw is an integer below this, which a double holds exactly.
  static constexpr double kWhole = 9007199254740992.0;  // 2^53

  constexpr RandomStream(std::uint64_t seed, std::string_view name)
      : state_(scrambled(scrambled(seed) ^ hash_of(name))) {}

  /// Number `index`; divided by kWhole it is uniform in [0, 1).
  [[nodiscard]] constexpr double draw(std::uint64_t index) const {
    constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;
    return static_cast<double>(scrambled(state_ + (index + 1) * kGolden) >>
                               11U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace brachisto::io
