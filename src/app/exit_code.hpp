// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// How the command ends: exit codes, fixed for scripts that rely on them, and
// what is said where there is no result.

#pragma once

#include <string>
#include <string_view>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve.hpp"
#include "sweep/store.hpp"

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
[[nodiscard]] int exit_code(const Solution& solution, int signal,
                            const DesignAnswer* design = nullptr);

/// The one document of a command with --json that has no result.
/// \param input  mistakes in the input, if that is why
[[nodiscard]] std::string failure_document(
    std::string_view status, std::string_view message,
    const io::InputError* input = nullptr);

/// Tells what is damaged in a store, if anything, and what is done about it.
void tell_damage(const sweep::Store& store, std::string_view remedy = "");

/// Tells it. \return the exit code of a verb that read the store and mended
/// nothing
[[nodiscard]] int exit_code(const sweep::Store& store);

}  // namespace brachisto::app
