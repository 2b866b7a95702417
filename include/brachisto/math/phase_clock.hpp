// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Which part of a solve the processor's time goes into.

#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace brachisto {

/// The parts of a solve. Time belongs to the innermost one that is timed, but
/// Start, Certificate and Diagnosis take all that happens within them.
enum class Phase {
  Start,          ///< from the cycloid to the coarse solution to refine
  SetUp,          ///< sparsity patterns, analysis of the matrix
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
