// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a solve takes, known before it begins, and whether there is as much.

#pragma once

#include <optional>
#include <string>

#include "brachisto/study/solve.hpp"
#include "study/pose.hpp"

namespace brachisto {

/// Of a problem that has a uniform cylinder's path; see brachisto::forecast().
[[nodiscard]] Forecast forecast(const PosedProblem& posed);

/// "about 200 nodes at most, 18 MB of memory, 0.02 s".
[[nodiscard]] std::string in_words(const Forecast& size);

/// Why a solve of that size is not begun: Status::OutOfMemory or
/// Status::TimeLimit; nothing if there is enough of both.
/// \param available_bytes  see available_memory()
/// \param seconds          the limit of the solve
[[nodiscard]] std::optional<Outcome> too_large(const Forecast& size,
                                               double available_bytes,
                                               double seconds);

/// The same with the memory that there is.
[[nodiscard]] std::optional<Outcome> too_large(const Forecast& size,
                                               double seconds);

/// How much more memory this process may take before something else has to
/// give way [bytes]: the least of what the kernel says is available, what is
/// left of the address space that RLIMIT_AS allows, and what the control groups
/// of the process leave. Infinite where nothing is known.
[[nodiscard]] double available_memory();

}  // namespace brachisto
