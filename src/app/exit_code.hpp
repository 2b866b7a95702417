// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Exit codes of the command, fixed for scripts that rely on them.

#pragma once

#include "brachisto/study/solve.hpp"

namespace brachisto::app {

enum ExitCode : int {
  kSuccess = 0,        ///< solved and verified
  kInternalError = 1,  ///< a fault of the program
  kUsage = 2,          ///< wrong command line
  kBadInput = 3,       ///< the problem file is refused
  kNotSolved = 4,      ///< not solved, or not verified
  kInfeasible = 5,     ///< verified, but the body could not run on the track
  kIoError = 6,        ///< a file cannot be read or written
  kLimit = 7,          ///< of iterations, time or memory
  kSignalBase = 128,   ///< plus the signal's number after SIGINT and SIGTERM
};

/// The code for the outcome of a solve; `signal` is the one received, or 0.
[[nodiscard]] int exit_code(const Solution& solution, int signal);

}  // namespace brachisto::app
