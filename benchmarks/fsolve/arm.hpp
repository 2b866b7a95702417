// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paper's discrete system given to one solver after the other.

#pragma once

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "support/text.hpp"

namespace brachisto::benchmarks {

/// Who solves the 2n + 1 equations.
enum class Arm {
  Octave,  ///< its own fsolve, a program of others
  SciPy,   ///< its own fsolve, a program of others
  Hybrid,  ///< the method of SciPy's fsolve, in this library
  Newton,  ///< exact derivatives, ε → 0, dense matrices
  Lifted,  ///< the same with θ_j as unknowns and sparse matrices
  /// The equations with ε, by steps of Lifted: where those of Hybrid take too
  /// long. It converges as long as ε is well below the length of a chord.
  Simplified,
};

[[nodiscard]] const char* name(Arm arm);
[[nodiscard]] const char* name(DiscreteReading::Datum datum);

/// One solve to be measured.
struct DiscreteTask {
  Arm arm = Arm::Hybrid;
  DiscreteReading::Datum datum = DiscreteReading::Datum::Rest;
  int nodes = 100;
  double epsilon = 1e-3;  ///< in units of H; Newton and Lifted have none
};

/// What came of it.
struct DiscreteRun {
  enum class Outcome { Solved, Failed, Capped, Absent };
  Outcome outcome = Outcome::Failed;
  double tau = 0.0;          ///< if solved
  double error = 0.0;        ///< if solved: relative, against the extremal
  double cpu_seconds = 0.0;  ///< of the solve alone; the cap if it was reached
  int evaluations = 0;
  int repetitions = 0;  ///< that cpu_seconds was taken from
  FixedText<200> cause;

  [[nodiscard]] bool solved() const { return outcome == Outcome::Solved; }
  [[nodiscard]] bool timed() const {
    return solved() || outcome == Outcome::Capped;
  }
};

/// A task with its run.
struct DiscretePoint {
  DiscreteTask task;
  DiscreteRun run;
};

/// Solves by an arm of this library, again and again after a warm-up until
/// 0.2 s have passed; cpu_seconds is the mean. A solve of more than that is
/// timed once.
[[nodiscard]] DiscreteRun run_here(const Scene& scene,
                                   const DiscreteTask& task);

}  // namespace brachisto::benchmarks
