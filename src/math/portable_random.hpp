// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Random numbers that are the same everywhere: the distributions of the
/// standard library differ from one library to another.

#pragma once

#include <cstdint>
#include <string_view>

namespace brachisto {

/// SplitMix64 [Steele, Lea and Flood 2014]: a counter, scrambled.
class SplitMix64 {
 public:
  static constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15U;

  constexpr explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  [[nodiscard]] static constexpr std::uint64_t scrambled(std::uint64_t x) {
    x = (x ^ (x >> 30U)) * 0xBF58476D1CE4E5B9U;
    x = (x ^ (x >> 27U)) * 0x94D049BB133111EBU;
    return x ^ (x >> 31U);
  }

  constexpr std::uint64_t next() { return scrambled(state_ += kGolden); }

  /// In [0, 1), with 53 random bits.
  constexpr double uniform() {
    return static_cast<double>(next() >> 11U) * 0x1p-53;
  }
  /// In [low, high).
  constexpr double uniform(double low, double high) {
    return low + (high - low) * uniform();
  }

 private:
  std::uint64_t state_;
};

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
/// outputs of SplitMix64, started at a state scrambled from seed and name.
class RandomStream {
 public:
  /// A draw is an integer below this, which a double holds exactly.
  static constexpr double kWhole = 9007199254740992.0;  // 2^53

  constexpr RandomStream(std::uint64_t seed, std::string_view name)
      : state_(SplitMix64::scrambled(SplitMix64::scrambled(seed) ^
                                     hash_of(name))) {}

  /// Number `index`; divided by kWhole it is uniform in [0, 1).
  [[nodiscard]] constexpr double draw(std::uint64_t index) const {
    SplitMix64 random(state_ + index * SplitMix64::kGolden);
    return static_cast<double>(random.next() >> 11U);
  }

 private:
  std::uint64_t state_;
};

}  // namespace brachisto
