// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Nodes, elements and unknowns are numbered by int, as formulas do it;
// containers want another type.

#pragma once

#include <cstddef>

namespace brachisto {

[[nodiscard]] constexpr std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace brachisto
