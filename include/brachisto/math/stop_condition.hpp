// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What stops a long computation from outside.

#pragma once

#include <atomic>
#include <chrono>
#include <concepts>
#include <exception>

namespace brachisto {

/// A point in time and a flag. Shared by all passes of a solve, so that limits
/// bound the whole of it.
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

/// What check_stop() leaves a loop with.
class Stopped : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override {
    return "stopped before the end";
  }
};

/// Puts a condition in force in this thread for as long as it lives, beside
/// those that are.
class StopScope {
 public:
  explicit StopScope(const StopCondition& stop);
  ~StopScope();
  StopScope(const StopScope&) = delete;
  StopScope& operator=(const StopScope&) = delete;

  [[nodiscard]] bool met() const {
    return stop_.met() || (before_ != nullptr && before_->met());
  }

 private:
  StopCondition stop_;
  const StopScope* before_;
};

/// Leaves whatever is being computed if a condition in force is met. Belongs
/// into every loop whose length grows with a mesh; it takes some 20 ns.
/// \throws Stopped
void check_stop();

/// The same in one of 1024 turns, for loops whose turns take microseconds.
inline void check_stop(std::integral auto turn) {
  if (turn % 1024 == 0) check_stop();
}

}  // namespace brachisto
