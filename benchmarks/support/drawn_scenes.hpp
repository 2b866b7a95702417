// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The options of a program that runs random scenes, each in a process of its
/// own.

#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "support/processes.hpp"
#include "support/table.hpp"

namespace brachisto::benchmarks {

struct DrawnScenes {
  std::uint64_t seed = 1;
  int count = 0;
  int first = 0;
  ProcessLimits limits;
  std::string out;  ///< CSV file

  void read_from(CLI::App& app) {
    app.add_option("--seed", seed, "Of the random scenes")
        ->capture_default_str();
    app.add_option("--count", count, "How many scenes")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--first", first, "Number of the first scene")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    app.add_option("--jobs", limits.jobs, "Processes at a time")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--seconds", limits.seconds, "For one scene, at most")
        ->capture_default_str();
    app.add_option("--out", out, "CSV file")->capture_default_str();
  }

  /// "Seed 1, scenes 0 to 99. …": the head of what is said of them.
  [[nodiscard]] std::string described() const {
    return "Seed " + std::to_string(seed) + ", scenes " +
           std::to_string(first) + " to " + std::to_string(first + count - 1) +
           ". " + machine() + ".";
  }
};

}  // namespace brachisto::benchmarks
