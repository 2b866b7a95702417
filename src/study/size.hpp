// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a solve takes at least, known before it begins.

#pragma once

#include <optional>

#include "study/pose.hpp"

namespace brachisto {

/// A lower estimate of memory and time.
struct SizeEstimate {
  double turns = 0.0;  ///< of the body on its way; 0 if they do not matter
  double nodes = 0.0;  ///< of a fixed mesh; 0 if the mesh follows
  double bytes = 0.0;
  double seconds = 0.0;
};

/// \param turns  of the body along the path of the uniform cylinder
[[nodiscard]] SizeEstimate estimate_size(double turns,
                                         const SolveOptions& options);

/// Why a solve of that size is not begun: Status::OutOfMemory or
/// Status::TimeLimit; nothing if there is enough of both.
/// \param available_bytes  see available_memory()
/// \param seconds          the limit of the solve
[[nodiscard]] std::optional<Outcome> too_large(const SizeEstimate& size,
                                               double available_bytes,
                                               double seconds);

/// The same of a solve, with the memory and the time that it has.
[[nodiscard]] std::optional<Outcome> too_large(const PosedProblem& posed);

/// How much more memory this process may take before something else has to
/// give way [bytes]: the least of what the kernel says is available, what is
/// left of the address space that RLIMIT_AS allows, and what the control group
/// of the process may have. Infinite where nothing is known.
[[nodiscard]] double available_memory();

}  // namespace brachisto
