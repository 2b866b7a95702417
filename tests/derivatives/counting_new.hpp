// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Counts the allocations of the program it is linked into.

#pragma once

namespace brachisto::testing {

/// How often the program has called operator new so far.
[[nodiscard]] long num_allocations();
/// Of all of them together.
[[nodiscard]] double allocated_bytes();

}  // namespace brachisto::testing
