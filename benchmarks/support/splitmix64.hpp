// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A random generator whose numbers are the same everywhere.

#pragma once

#include <cstdint>

namespace brachisto::benchmarks {

/// SplitMix64 [Steele, Lea and Flood 2014]. The distributions of the standard
/// library differ from one library to another; these do not.
class SplitMix64 {
 public:
  explicit SplitMix64(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }

  /// In [low, high), with 53 random bits.
  double uniform(double low, double high) {
    const double unit = static_cast<double>(next() >> 11U) * 0x1p-53;
    return low + (high - low) * unit;
  }

 private:
  std::uint64_t state_;
};

}  // namespace brachisto::benchmarks
