// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the benchmark measures, and what is written of it.

#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brachisto/run/solve_options.hpp"
#include "report/chart.hpp"

namespace brachisto::benchmarks {

enum class Peer { NewtonChain, IpoptChain, IpoptMumps, IpoptMumpsNl };

/// A way to solve a program, in words.
struct Way {
  const char* name;
  Formulation formulation;
  Peer peer;
};

inline constexpr Way kWays[] = {
    {"rolling_time, Newton, chain", Formulation::RollingTime,
     Peer::NewtonChain},
    {"rolling_time, Ipopt, chain", Formulation::RollingTime, Peer::IpoptChain},
    {"rolling_time, Ipopt, MUMPS", Formulation::RollingTime, Peer::IpoptMumps},
    {"rolling_time, Ipopt, MUMPS, .nl", Formulation::RollingTime,
     Peer::IpoptMumpsNl},
    {"arc_length, Newton, chain", Formulation::ArcLength, Peer::NewtonChain},
    {"arc_length, Ipopt, chain", Formulation::ArcLength, Peer::IpoptChain},
    {"arc_length, Ipopt, MUMPS", Formulation::ArcLength, Peer::IpoptMumps},
    {"arc_length, Ipopt, MUMPS, .nl", Formulation::ArcLength,
     Peer::IpoptMumpsNl}};

/// What a process came to; copied between processes byte by byte.
struct Record {
  bool solved;
  int variables, iterations;
  double error;     ///< of τ, relative
  double residual;  ///< largest of the optimality conditions, unscaled
  /// Processor time, user and system [s]: to make the program and its start or
  /// to read them; to solve; within that for functions and derivatives.
  double made_seconds, solve_seconds, evaluation_seconds;
  double gigabytes;  ///< peak
};

/// Processes that were to measure the same thing.
struct Run {
  int way = 0;  ///< of kWays
  int nodes = 0;
  int repeats = 0;
  std::optional<Record> record;  ///< medians; none: see fate
  std::string fate;
};

/// \param records  not empty
[[nodiscard]] Record median(std::span<const Record> records);

/// One row per run.
[[nodiscard]] std::string csv(const std::vector<Run>& runs);

/// The runs of such a file, to the digits that are written there.
/// \throws std::runtime_error if it cannot be read
[[nodiscard]] std::vector<Run> read_runs(const std::string& path);

/// A row for each size and formulation: the solve by each peer.
[[nodiscard]] std::string markdown(const std::vector<Run>& runs);

/// Processor time of the solve over nodes.
/// \param path  of its files, without ending
[[nodiscard]] report::Chart chart(const std::vector<Run>& runs,
                                  const std::string& path);

}  // namespace brachisto::benchmarks
