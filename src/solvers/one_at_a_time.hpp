// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// Libraries that keep their state in variables of the process, one thread at a
// time: MUMPS, Ipopt with the functions that take the place of HSL's, and the
// number of threads of BLAS.

#pragma once

#include <mutex>

namespace brachisto {

/// The place in which these libraries may be called, held as long as it lives.
/// A thread that holds it may ask again: the functions of an outer problem may
/// be solves themselves, and runs within runs do not meet, for each has its own
/// instance of either library.
///
/// A threaded BLAS, if that is what is loaded, has one thread meanwhile: the
/// matrices are small, more would only burn processor time and blur its
/// measurement.
class OneAtATime {
 public:
  /// Waits for its turn.
  /// \throws Stopped  if a condition in force is met before it comes
  OneAtATime();
  ~OneAtATime();
  OneAtATime(const OneAtATime&) = delete;
  OneAtATime& operator=(const OneAtATime&) = delete;

 private:
  std::unique_lock<std::recursive_timed_mutex> lock_;
  int blas_threads_ = 0;  ///< to go back to; 0: none that can be set
};

}  // namespace brachisto
