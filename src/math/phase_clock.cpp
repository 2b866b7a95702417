// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "brachisto/math/clock.hpp"

#include <algorithm>

#include "math/cpu_clock.hpp"

namespace brachisto {

namespace {

struct State {
  PhaseSeconds sums;
  Phase now = Phase::Other;
  double since = thread_cpu_seconds();

  double& sum(Phase phase) {
    return sums.seconds[static_cast<std::size_t>(phase)];
  }
  void change_to(Phase phase) {
    const double time = thread_cpu_seconds();
    sum(now) += time - since;
    since = time;
    now = phase;
  }
};

thread_local State state;

bool takes_all(Phase phase) {
  return phase == Phase::Start || phase == Phase::Certificate ||
         phase == Phase::Diagnosis;
}

}  // namespace

std::string_view name(Phase phase) {
  constexpr std::array<std::string_view, kNumPhases> kNames{
      "start", "set_up",      "evaluation", "factorisation", "solution",
      "ipopt", "certificate", "diagnosis",  "other"};
  return kNames.at(static_cast<std::size_t>(phase));
}

PhaseSeconds& PhaseSeconds::operator-=(const PhaseSeconds& other) {
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    seconds[i] -= other.seconds[i];
  }
  return *this;
}

PhaseSeconds phase_seconds() {
  state.change_to(state.now);
  return state.sums;
}

void move_phase_seconds(Phase from, Phase to, double seconds) {
  if (takes_all(state.now)) return;
  seconds = std::clamp(seconds, 0.0, std::max(0.0, state.sum(from)));
  state.sum(from) -= seconds;
  state.sum(to) += seconds;
}

PhaseTimer::PhaseTimer(Phase phase) : before_(state.now) {
  // Clocks cost time too.
  if (!takes_all(before_) && phase != before_) state.change_to(phase);
}

PhaseTimer::~PhaseTimer() {
  if (state.now != before_) state.change_to(before_);
}

}  // namespace brachisto
