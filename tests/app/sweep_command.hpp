// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep of a few scenes, run by the command.

#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "app/command.hpp"
#include "support/scratch_directory.hpp"

namespace brachisto::testing {

/// Scenes of small_sweep(): 2 rows of 18, each of two chains.
inline constexpr int kScenes = 36;

/// Writes the problem file of a sweep around the reference case.
[[nodiscard]] inline std::string small_sweep(const ScratchDirectory& scratch) {
  return scratch.file(
      "sweep.yaml",
      "scene:\n"
      "  body: {shape: cylinder, radius: 1/3, k: 1/2}\n"
      "  finish: {L: 3, H: 1}\n"
      "discretisation: {tolerance: 1e-8}\n"
      "sweep:\n"
      "  scene.body.eta_m: [1/3, 2/3]\n"
      "  scene.body.theta_m: {from: -60 deg, to: 60 deg, count: 18}\n");
}

/// Waits until a file is there.
inline void wait_for(const std::filesystem::path& file) {
  while (!std::filesystem::exists(file)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

/// Runs the sweep into a directory of that name.
[[nodiscard]] inline Output sweep(const ScratchDirectory& scratch,
                                  const std::string& name,
                                  const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"sweep", small_sweep(scratch), "--out",
                                     (scratch.path() / name).string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run(std::move(arguments));
}

/// The exported table without the times, which are all that may differ.
[[nodiscard]] inline std::string table_of(const ScratchDirectory& scratch,
                                          const std::string& name) {
  const Output output =
      run({"export", (scratch.path() / name).string(), "--csv"});
  std::istringstream lines(output.out);
  std::string line, text;
  std::size_t seconds = std::string::npos;  // number of the column
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field;
    for (std::size_t column = 0; std::getline(fields, field, ','); ++column) {
      if (field == "seconds.total") seconds = column;
      if (column != seconds) text += field + ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace brachisto::testing
