// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a solve takes at least, known before it begins.

#pragma once

#include <optional>
#include <string>

#include "brachisto/model/scene.hpp"
#include "brachisto/solvers/status.hpp"
#include "brachisto/study/solve_options.hpp"

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

/// Why a solve of that size is not begun.
struct TooLarge {
  Status status;  ///< OutOfMemory or TimeLimit
  std::string message;
};

/// Nothing if there is enough of both.
/// \param available_bytes  see available_memory()
/// \param seconds          the limit of the solve
[[nodiscard]] std::optional<TooLarge> too_large(const SizeEstimate& size,
                                                double available_bytes,
                                                double seconds);

}  // namespace brachisto
