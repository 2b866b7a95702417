// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of an answer and what goes with it, for the verbs that write it.

#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/model/scene.hpp"
#include "brachisto/report/output_files.hpp"
#include "plot/trajectory_table.hpp"
#include "report/result_field.hpp"

namespace brachisto::app {

struct PageFiles {
  std::vector<report::OutputFile> files;
  std::string missing;  ///< why there is no picture that moves; or empty
};

/// index.html and, if asked for, motion.gif with its table and script.
/// \param result  the document of a verified result
/// \param csv     its trajectory.csv
/// \throws plot::NoTrajectory, Stopped
[[nodiscard]] PageFiles page_files(const report::Json& result,
                                   const Scene& scene, std::string_view csv,
                                   bool gif, const std::atomic<int>& signal);

/// The names of all that there may be.
[[nodiscard]] std::vector<std::string> page_file_names();

}  // namespace brachisto::app
