// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Times of work that takes less than a clock can tell.

#pragma once

namespace brachisto::benchmarks {

struct MeanTime {
  double seconds = 0.0;
  int repetitions = 0;
};

/// The mean of the seconds that `work` returns, over so many calls that they
/// add up to 0.2 s. The first call is a warm-up and does not count, unless it
/// alone takes longer than that.
template <class Work>
[[nodiscard]] MeanTime mean_time(Work&& work) {
  constexpr double kEnough = 0.2;  // [s]
  const double first = work();
  if (first >= kEnough) return {first, 1};
  double total = 0.0;
  int repetitions = 0;
  while (total < kEnough) {
    total += work();
    ++repetitions;
  }
  return {total / repetitions, repetitions};
}

}  // namespace brachisto::benchmarks
