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

[[nodiscard]] inline WallClock::time_point seconds_from_now(double seconds) {
  return WallClock::now() + std::chrono::duration_cast<WallClock::duration>(
                                std::chrono::duration<double>(seconds));
}

}  // namespace brachisto
