// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What stops a long computation from outside.

#pragma once

#include <atomic>
#include <chrono>

namespace brachisto {

/// A point in time and a flag, both looked at between iterations. Shared by all
/// passes of a solve, so that limits bound the whole of it.
class StopCondition {
 public:
  using Clock = std::chrono::steady_clock;

  /// Never stops.
  StopCondition() = default;
  /// \param seconds    from now
  /// \param interrupt  set from a signal handler to stop; may be null, must
  ///                   outlive this
  StopCondition(double seconds, const std::atomic<int>* interrupt);

  [[nodiscard]] bool interrupted() const {
    return interrupt_ != nullptr && interrupt_->load() != 0;
  }
  [[nodiscard]] bool out_of_time() const { return Clock::now() >= deadline_; }
  [[nodiscard]] bool met() const { return interrupted() || out_of_time(); }

 private:
  Clock::time_point deadline_ = Clock::time_point::max();
  const std::atomic<int>* interrupt_ = nullptr;
};

}  // namespace brachisto
