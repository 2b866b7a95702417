// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Numbers that many tests name.

#pragma once

#include <limits>
#include <numbers>

namespace brachisto::testing {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace brachisto::testing
