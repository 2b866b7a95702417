// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// SIGINT and SIGTERM as a flag that solvers look at between iterations.

#pragma once

#include <atomic>

namespace brachisto::app {

/// Installs the handlers. The first signal sets the flag to its number; one
/// that follows later than at once ends the process as usual.
/// \return the flag, 0 as long as no signal came
[[nodiscard]] const std::atomic<int>& catch_signals();

}  // namespace brachisto::app
