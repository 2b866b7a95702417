// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Time: what stops a long computation from outside, and which part of a
/// solve the processor's time goes into.

#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <concepts>
#include <cstddef>
#include <exception>
#include <string_view>

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
  /// At the interrupt alone.
  explicit StopCondition(const std::atomic<int>* interrupt)
      : interrupt_(interrupt) {}

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

/// The parts of a solve. Time belongs to the innermost one that is timed, but
/// Start, Certificate and Diagnosis take all that happens within them.
enum class Phase {
  Start,  ///< from the cycloid to the coarse solution to refine, under limits
          ///< with the search for its arcs
  SetUp,  ///< sparsity patterns, analysis of the matrix
  Evaluation,     ///< functions and derivatives
  Factorisation,  ///< of the KKT matrix
  Solution,       ///< right-hand sides, with refinement
  Ipopt,          ///< Ipopt's own work
  Certificate,
  Diagnosis,  ///< forces, curvatures and self-crossings of the motion
  Other
};
inline constexpr std::size_t kNumPhases = 9;

/// Name as in results, such as "set_up".
[[nodiscard]] std::string_view name(Phase phase);

/// Processor time by phase [s].
struct PhaseSeconds {
  std::array<double, kNumPhases> seconds{};

  [[nodiscard]] double of(Phase phase) const {
    return seconds[static_cast<std::size_t>(phase)];
  }
  PhaseSeconds& operator-=(const PhaseSeconds& other);
};

/// Of this thread so far; what is under way is included.
[[nodiscard]] PhaseSeconds phase_seconds();

/// Books seconds under another phase, for work that others timed; no more than
/// there are.
void move_phase_seconds(Phase from, Phase to, double seconds);

/// Books the time for which it lives.
class PhaseTimer {
 public:
  explicit PhaseTimer(Phase phase);
  ~PhaseTimer();
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  Phase before_;
};

}  // namespace brachisto
