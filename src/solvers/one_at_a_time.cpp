// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "solvers/one_at_a_time.hpp"

#include <chrono>

#include "brachisto/math/stop_condition.hpp"

namespace brachisto {

namespace {

std::timed_mutex place;

}  // namespace

OneAtATime::OneAtATime() : lock_(place, std::defer_lock) {
  constexpr std::chrono::milliseconds kPatience{50};
  while (!lock_.try_lock_for(kPatience)) check_stop();
}

}  // namespace brachisto
