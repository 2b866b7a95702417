// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The larger one of two numbers.

#pragma once

#include <cmath>

namespace brachisto {

/// The larger one; not a number stays what it is.
[[nodiscard]] inline double larger(double a, double b) {
  return a < b || std::isnan(b) ? b : a;
}

}  // namespace brachisto
