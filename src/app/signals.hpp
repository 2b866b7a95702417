// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// SIGINT and SIGTERM as a flag that solvers look at between iterations, and the
// end of a solve that does not stop in order soon enough: while Ipopt prepares
// its matrix, and while MUMPS or KLU factorises one, nobody looks at the clock
// or at signals, at a million nodes for seconds; and a machine may be too busy.

#pragma once

#include <atomic>

namespace brachisto::app {

/// Installs the handlers. The first signal sets the flag to its number; one
/// that follows later than at once ends the process as usual.
/// \return the flag, 0 as long as no signal came
[[nodiscard]] const std::atomic<int>& catch_signals();

/// Ends the process if a solve goes on too long after a signal or its limit of
/// time: with the exit code for it, a line on stderr, and the one document on
/// stdout if there has to be one. Nothing is being written meanwhile, so that
/// nothing is left half-written.
class LastResort {
 public:
  /// In force as long as it lives. One at a time.
  /// \param seconds  the limit of the solve, from now
  /// \param json     whether stdout is to get a document
  LastResort(double seconds, bool json);
  ~LastResort();
  LastResort(const LastResort&) = delete;
  LastResort& operator=(const LastResort&) = delete;
};

}  // namespace brachisto::app
