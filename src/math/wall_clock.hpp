// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Seconds on the wall.

#pragma once

#include <chrono>

namespace brachisto {

using WallClock = std::chrono::steady_clock;

[[nodiscard]] inline double seconds_between(WallClock::time_point begin,
                                            WallClock::time_point end) {
  return std::chrono::duration<double>(end - begin).count();
}

[[nodiscard]] inline double seconds_since(WallClock::time_point begin) {
  return seconds_between(begin, WallClock::now());
}

[[nodiscard]] inline double seconds_until(WallClock::time_point end) {
  return seconds_between(WallClock::now(), end);
}

/// Of more than a century the end of all time.
[[nodiscard]] inline WallClock::time_point seconds_from_now(double seconds) {
  // Beyond that the clock's own range would matter.
  constexpr double kForever = 3e9;
  if (seconds >= kForever) return WallClock::time_point::max();
  return WallClock::now() + std::chrono::duration_cast<WallClock::duration>(
                                std::chrono::duration<double>(seconds));
}

}  // namespace brachisto
