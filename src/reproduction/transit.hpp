// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The transit time of a scene as a function.

#pragma once

#include <atomic>
#include <stdexcept>

#include "brachisto/study/solve.hpp"

namespace brachisto::reproduction {

/// Something has no verified answer; what() says what and why.
class NotVerified : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A signal came.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("stopped by a signal") {}
};

/// The flag that a signal sets.
using Interrupt = std::atomic<int>;

/// \throws Interrupted  if the flag is set
void check(const Interrupt& interrupt);

/// The answer to a scene, to a relative error of 1e-12 unless told.
/// \throws NotVerified  without a verified answer
/// \throws Interrupted
[[nodiscard]] Solution verified_solution(const Scene& scene,
                                         const Interrupt& interrupt,
                                         double tolerance = 1e-12);

/// Its τ.
[[nodiscard]] double verified_tau(const Scene& scene,
                                  const Interrupt& interrupt);

}  // namespace brachisto::reproduction
