// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/clock.hpp"

namespace brachisto {

namespace {

thread_local const StopScope* in_force = nullptr;

}  // namespace

StopCondition::StopCondition(double seconds, const std::atomic<int>* interrupt)
    : interrupt_(interrupt) {
  // Beyond a century the clock's own range would matter.
  constexpr double kForever = 3e9;
  if (seconds >= kForever) return;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                 std::chrono::duration<double>(seconds));
}

StopScope::StopScope(const StopCondition& stop)
    : stop_(stop), before_(in_force) {
  in_force = this;
}

StopScope::~StopScope() {
  in_force = before_;
}

void check_stop() {
  if (in_force != nullptr && in_force->met()) throw Stopped();
}

}  // namespace brachisto
