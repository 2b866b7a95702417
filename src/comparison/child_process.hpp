// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// One run of a program, and what it cost.

#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

namespace brachisto::comparison {

/// A process that has ended, and how.
struct ChildRun {
  enum class End {
    Exited,       ///< by itself, with `code`
    Signalled,    ///< by a signal, `code`, that we did not send
    OutOfTime,    ///< killed at the limit
    Interrupted,  ///< killed because the caller is to stop
  };

  End end = End::Exited;
  int code = 0;
  std::string out, err;
  double seconds = 0.0;      ///< wall clock, from start to end
  double peak_memory = 0.0;  ///< largest resident set [bytes]
};

/// Runs a program with its output in pipes, and kills it at the limit.
///
/// The kernel counts as peak memory at least what the caller had resident when
/// it started the program. A caller that is the same program and has solved
/// nothing has less than any run of it.
///
/// \param seconds    wall-clock limit
/// \param interrupt  nonzero: stop; may be null
/// \throws std::system_error if it cannot be started
[[nodiscard]] ChildRun run_child(const std::filesystem::path& program,
                                 const std::vector<std::string>& arguments,
                                 double seconds,
                                 const std::atomic<int>* interrupt);

}  // namespace brachisto::comparison
