// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// One method on one mesh, run in a process of its own: what came out, and what
/// it cost.

#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/run/solve_options.hpp"
#include "brachisto/study/solution.hpp"

namespace brachisto::comparison {

/// What to run.
struct Experiment {
  std::string file;                    ///< problem file
  std::vector<std::string> overrides;  ///< KEY=VALUE, the last one wins
  SolveOptions options;                ///< in place of what the file says
  int repetitions = 1;                 ///< timed runs, at most
  double seconds = 60.0;               ///< wall clock, all repetitions together
};

/// What came of it.
struct Measurement {
  enum class Outcome {
    Solved,   ///< there is a transit time
    Failed,   ///< the solver gave up
    Limit,    ///< the time was up
    Crashed,  ///< the process ended without a result
    Refused,  ///< the method does not take such a problem
  };

  Outcome outcome = Outcome::Crashed;
  std::string cause;  ///< why there is no transit time, or no certificate

  // Of what was solved:
  double tau = 0.0;                       ///< T √(2 g/H) [-]
  bool verified = false;                  ///< by the certificate
  std::optional<double> estimated_error;  ///< relative, the method's own
  /// max |w²/2g − E| of the certificate; nothing where w comes from energy.
  std::optional<double> energy_drift;
  std::vector<Point> path;  ///< see places_along()
  std::vector<double> cpu;  ///< processor time of each repetition [s]
  /// Of these the start, from the cycloid to what the mesh begins with, under
  /// limits with the search for arcs [s]; empty or as many.
  std::vector<double> start;

  // Of what ran to its end:
  std::optional<int> unknowns, iterations, newton_steps, evaluations;
  double peak_memory = 0.0;  ///< of the process [bytes]
  double seconds = 0.0;      ///< wall clock of the process

  [[nodiscard]] bool solved() const { return outcome == Outcome::Solved; }
  /// Processor times without the start [s]; empty if that is not known.
  [[nodiscard]] std::vector<double> on_mesh() const;
};

/// "solved", "failed", "limit", "crashed", "refused".
[[nodiscard]] const char* name(Measurement::Outcome outcome);

/// Before anything is read or run.
/// \throws io::IoError  of what measure() cannot read: standard input
void check_named(const std::string& file);

/// Runs `PROGRAM measure`, which is this program.
/// \throws Interrupted, std::system_error
[[nodiscard]] Measurement measure(const Experiment& experiment,
                                  const std::atomic<int>* interrupt);

/// Why it refused, in words, from the document that it printed; the first line
/// of what it said otherwise if there is none.
[[nodiscard]] std::string refusal_in(const std::string& document,
                                     const std::string& otherwise);

/// Reads what `measure` printed in one line; an outcome Crashed if it is not
/// that.
[[nodiscard]] Measurement parse_measurement(const std::string& line);

/// Places of the centre at equal parts of its path, both ends included [m]; of
/// the discrete system on the chords between its nodes. Empty without a
/// solution.
[[nodiscard]] std::vector<Point> places_along(const Solution& solution);

/// The largest distance between places that belong together, relative to
/// `length`; nothing unless both paths have the same number of them.
[[nodiscard]] std::optional<double> path_error(
    const std::vector<Point>& places, const std::vector<Point>& reference,
    double length);

}  // namespace brachisto::comparison
