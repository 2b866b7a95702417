// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Processor time, which a busy machine does not stretch as it does a wall
/// clock.

#pragma once

#include <ctime>

namespace brachisto {

/// What a clock of the system shows [s].
[[nodiscard]] inline double clock_seconds(clockid_t clock) {
  constexpr double kNano = 1e-9;
  std::timespec now{};
  ::clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) +
         kNano * static_cast<double>(now.tv_nsec);
}

/// Processor time that this process has used, all its threads together [s].
[[nodiscard]] inline double process_cpu_seconds() {
  return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

/// Processor time that this thread has used [s].
[[nodiscard]] inline double thread_cpu_seconds() {
  return clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

}  // namespace brachisto
