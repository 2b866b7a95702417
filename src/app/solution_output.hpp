// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a command with one solution as its result writes and prints.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "brachisto/report/output_files.hpp"
#include "brachisto/study/solve.hpp"

namespace brachisto::app {

inline constexpr const char* kResultFile = "result.json";
inline constexpr const char* kTrajectoryFile = "trajectory.csv";

/// Where a solution goes.
struct SolutionOutput {
  std::string out;  ///< directory; empty: none
  bool force = false, json = false, quiet = false;
  /// Files of the command besides, which --out writes too.
  std::vector<report::OutputFile> further = {};
  bool gif = false;  ///< the motion as a picture too
};

/// All files of a solution in --out.
[[nodiscard]] std::vector<std::string> solution_files();

/// Why the exit code is not zero, for those who see nothing else.
[[nodiscard]] std::string complaint(const Solution& solution);

/// Writes and prints a solution. \return the exit code
/// \param signal  that was received, or 0
int hand_out(Solution& solution, SolutionOutput output,
             const std::atomic<int>& signal);

}  // namespace brachisto::app
