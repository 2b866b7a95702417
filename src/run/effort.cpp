// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/run/solve_options.hpp"

namespace brachisto {

Work& Work::operator+=(const Work& other) {
  iterations += other.iterations;
  passes += other.passes;
  newton_steps += other.newton_steps;
  log += other.log;
  return *this;
}

}  // namespace brachisto
