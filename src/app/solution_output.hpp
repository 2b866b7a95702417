// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// What a command with one solution as its result writes and prints.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/report/result.hpp"
#include "brachisto/study/solve.hpp"
#include "plot/trajectory_table.hpp"
#include "report/figure.hpp"
#include "report/result_texts.hpp"

namespace brachisto::app {

inline constexpr const char* kResultFile = "result.json";
inline constexpr const char* kTrajectoryFile = "trajectory.csv";

/// Where a solution goes.
struct SolutionOutput {
  std::string out;  ///< directory; empty: none
  bool force = false, json = false, quiet = false;
  /// Files of the command besides, which --out writes too.
  std::vector<report::OutputFile> further = {};
  bool gif = false;                      ///< the motion as a picture too
  const DesignAnswer* design = nullptr;  ///< that chose the body
};

/// index.html and, if asked for, motion.gif with its table and script.
/// \param result  the document of a verified result
/// \param table   of its trajectory.csv
/// \throws Stopped
[[nodiscard]] report::DrawnFiles page_files(const report::Json& result,
                                            const Scene& scene,
                                            const plot::TrajectoryTable& table,
                                            bool gif,
                                            const std::atomic<int>& signal);

/// All files of a solution in --out.
[[nodiscard]] std::vector<std::string> solution_files();

/// Why the exit code is not zero, for those who see nothing else.
[[nodiscard]] std::string complaint(const Solution& solution);

/// Tells what is read in a problem file, but hardly meant.
void warn_of(const io::ProblemFile& problem);

/// Solves a problem; a solve that goes on too long after a signal or its limit
/// of time ends the process, see LastResort.
/// \param json  whether stdout is to get a document
[[nodiscard]] Solution solve_in_time(const io::ProblemFile& problem, bool json,
                                     const SolveHooks& hooks);

/// Writes and prints a solution. \return the exit code
/// \param signal  that was received, or 0
int hand_out(Solution& solution, SolutionOutput output,
             const std::atomic<int>& signal);

}  // namespace brachisto::app
