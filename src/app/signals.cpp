// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/signals.hpp"

#include <csignal>
#include <ctime>

#include "app/last_resort.hpp"

namespace brachisto::app {

namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

double now() {
  timespec time = {};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

extern "C" void handle(int signal) {
  // Only the handler touches it, and signals are blocked in it.
  static double first = 0.0;
  // `timeout` sends each signal twice, to the process and to its group; a
  // person needs longer.
  constexpr double kTwice = 0.2;  // [s]
  if (received.load() == 0) {
    first = now();
  } else if (now() - first > kTwice) {
    std::signal(signal, SIG_DFL);
    ::raise(signal);
    return;
  }
  received.store(signal);
  LastResort::after_signal(signal);
}

}  // namespace

const std::atomic<int>& catch_signals() {
  struct sigaction action = {};
  action.sa_handler = handle;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return received;
}

}  // namespace brachisto::app
