// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the benchmark measures, and what is written of it.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/math/clock.hpp"
#include "brachisto/study/solve.hpp"
#include "report/chart.hpp"

namespace brachisto::benchmarks {

/// A way to solve, in words and as options.
struct Way {
  const char* name;
  Formulation formulation;
  ProgramSolver method;
  LinearSolver linear_solver;
};

inline constexpr Way kWays[] = {
    {"rolling_time, Newton, chain", Formulation::RollingTime,
     ProgramSolver::NewtonKkt, LinearSolver::Chain},
    {"rolling_time, Ipopt, chain", Formulation::RollingTime,
     ProgramSolver::Ipopt, LinearSolver::Chain},
    {"rolling_time, Ipopt, MUMPS", Formulation::RollingTime,
     ProgramSolver::Ipopt, LinearSolver::Mumps},
    {"arc_length, Newton, chain", Formulation::ArcLength,
     ProgramSolver::NewtonKkt, LinearSolver::Chain},
    {"arc_length, Ipopt, chain", Formulation::ArcLength, ProgramSolver::Ipopt,
     LinearSolver::Chain},
    {"arc_length, Ipopt, MUMPS", Formulation::ArcLength, ProgramSolver::Ipopt,
     LinearSolver::Mumps}};

/// What a solve came to; copied between processes byte by byte.
struct Record {
  bool verified;
  int nodes, iterations, newton_steps;
  double tau, error, estimated_error;   ///< relative
  double user_seconds, system_seconds;  ///< the whole process
  PhaseSeconds phases;                  ///< user and system, of solve()
  double gigabytes;                     ///< peak
};

/// A solve that was to be measured.
struct Run {
  int way = 0;                   ///< of kWays
  int nodes = 0;                 ///< wanted
  std::optional<Record> record;  ///< none: see fate
  std::string fate;
};

/// One row per run.
[[nodiscard]] std::string csv(const std::vector<Run>& runs);

/// The runs of such a file, to the digits that are written there.
/// \throws std::runtime_error if it cannot be read
[[nodiscard]] std::vector<Run> read_runs(const std::string& path);

/// User time over nodes, with the powers that fit from 1e4 nodes on.
/// \param path  of its files, without ending
[[nodiscard]] report::Chart chart(const std::vector<Run>& runs,
                                  const std::string& path);

}  // namespace brachisto::benchmarks
