// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Moments told by processor time, which come at the same place of a
/// computation however busy the machine is.

#pragma once

#include <atomic>
#include <chrono>
#include <thread>

#include "math/cpu_clock.hpp"

namespace brachisto::testing {

/// A flag that another thread sets once this process has worked so long.
class FlagAfterWork {
 public:
  /// \param seconds  of processor time, from now
  explicit FlagAfterWork(double seconds)
      : due_(process_cpu_seconds() + seconds) {}
  ~FlagAfterWork() {
    ended_ = true;
    thread_.join();
  }
  FlagAfterWork(const FlagAfterWork&) = delete;
  FlagAfterWork& operator=(const FlagAfterWork&) = delete;

  [[nodiscard]] const std::atomic<int>* flag() const { return &flag_; }
  /// Processor time that has gone by since then [s]; negative before.
  [[nodiscard]] double seconds_since() const {
    return process_cpu_seconds() - due_;
  }

 private:
  void watch() {
    while (!ended_ && process_cpu_seconds() < due_) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    flag_ = 2;
  }

  double due_;
  std::atomic<int> flag_{0};
  std::atomic<bool> ended_{false};
  std::thread thread_{[this] { watch(); }};
};

}  // namespace brachisto::testing
