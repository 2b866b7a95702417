// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Transit times as the paper prints them.

#pragma once

namespace brachisto::reproduction::printed {

inline constexpr const char* kBead = "4.52";
inline constexpr const char* kUniform = "5.12";
inline constexpr const char* kOffCentred = "4.99";  // also for n = 50, 100, 200
inline constexpr const char* kOffCentredCoarse = "4.97";  // n = 25
inline constexpr const char* kShort = "3.96";             // L = 2
inline constexpr const char* kLong = "6.26";              // L = 4
inline constexpr const char* kFast = "4.06";

}  // namespace brachisto::reproduction::printed
