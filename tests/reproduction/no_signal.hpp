// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// For computations that nobody interrupts.

#pragma once

#include "reproduction/cases.hpp"

namespace brachisto::testing {

inline const reproduction::Interrupt kNoSignal = 0;

}  // namespace brachisto::testing
