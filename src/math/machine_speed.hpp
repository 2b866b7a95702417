// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// How fast this machine is.

#pragma once

namespace brachisto {

/// Speed of one core relative to that on which docs/benchmarks.md was measured,
/// by half a millisecond of products of small matrices, the inner loops of a
/// solve. Measured at the first call of a process and kept.
[[nodiscard]] double machine_speed();

}  // namespace brachisto
