// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "app/signals.hpp"

#include <csignal>

#include "app/last_resort.hpp"

namespace brachisto::app {

namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void handle(int signal) {
  received.store(signal);
  LastResort::after_signal(signal);
}

}  // namespace

const std::atomic<int>& catch_signals() {
  struct sigaction action = {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return received;
}

}  // namespace brachisto::app
