// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

#include "report/in_full.hpp"

#include <unistd.h>

#include <atomic>

namespace brachisto::report {

namespace {

std::atomic<int> received{0};
static_assert(std::atomic<int>::is_always_lock_free,
              "a signal handler may touch lock-free atomics only");

extern "C" void hold(int signal) {
  received.store(signal);
}

}  // namespace

// A mask would not do: it holds for one thread, and the BLAS may have others.
HeldSignals::HeldSignals() {
  struct sigaction action = {};
  action.sa_handler = hold;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    // What is ignored stays so: under nohup, for instance.
    if (before_[i].sa_handler != SIG_IGN) {
      sigaction(kSignals[i], &action, nullptr);
    }
  }
}

HeldSignals::~HeldSignals() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
  if (const int signal = received.exchange(0); signal != 0) ::raise(signal);
}

bool HeldSignals::waiting() {
  return received.load() != 0;
}

namespace fs = std::filesystem;

NewDirectories::NewDirectories(const fs::path& directory,
                               std::error_code& error) {
  std::error_code ignored;
  for (fs::path missing = fs::absolute(directory);
       !fs::exists(missing, ignored) && missing.has_relative_path();
       missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  fs::create_directories(directory, error);
}

NewDirectories::~NewDirectories() {
  // The call refuses a directory that something is in.
  for (const fs::path& one : made_) ::rmdir(one.c_str());
}

}  // namespace brachisto::report
