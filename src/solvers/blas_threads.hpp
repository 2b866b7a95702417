// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// One thread of BLAS inside a solve: the matrices are small, more threads only
// burn processor time and blur its measurement.

#pragma once

namespace brachisto {

/// Sets a threaded BLAS, if that is what is loaded, to one thread for as long
/// as this lives.
class SingleThreadedBlas {
 public:
  SingleThreadedBlas();
  ~SingleThreadedBlas();
  SingleThreadedBlas(const SingleThreadedBlas&) = delete;
  SingleThreadedBlas& operator=(const SingleThreadedBlas&) = delete;

 private:
  int previous_ = 0;
};

}  // namespace brachisto
