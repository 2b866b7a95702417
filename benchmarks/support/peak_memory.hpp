// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#pragma once

#include <sys/resource.h>

namespace brachisto::benchmarks {

/// The most memory this process had so far [GB].
[[nodiscard]] inline double peak_gigabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024e-9 * static_cast<double>(usage.ru_maxrss);
}

}  // namespace brachisto::benchmarks
