// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Room on a terminal.

#pragma once

#include <cstddef>
#include <limits>

namespace brachisto::report {

/// What is not written to a terminal may be as long as it likes.
inline constexpr std::size_t kNoTerminal =
    std::numeric_limits<std::size_t>::max();

/// Letters that a line on stderr may have: where that is a terminal, one less
/// than it has columns, for a full row would leave the cursor in the next.
/// 79 if the terminal does not know.
[[nodiscard]] std::size_t columns_for_a_line();

}  // namespace brachisto::report
