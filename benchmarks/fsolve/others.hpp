// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The programs of others: GNU Octave and SciPy, where they are installed.

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fsolve/arm.hpp"

namespace brachisto::benchmarks {

/// A program that can be run.
struct OtherProgram {
  Arm arm = Arm::Octave;
  std::filesystem::path program;
  std::vector<std::string> arguments;  ///< before the options: the script
  std::string version;                 ///< "GNU Octave 7.3.0"
};

/// `octave-cli` on the PATH; nothing if there is none.
[[nodiscard]] std::optional<OtherProgram> find_octave();

/// The first `python3` on the PATH that has SciPy; nothing if none has.
[[nodiscard]] std::optional<OtherProgram> find_scipy();

/// Solves in processes of its own, on one thread: once, and twice more if that
/// took less than 2 s, of which the least counts.
/// \param cap  of processor time [s]
[[nodiscard]] DiscreteRun run_there(const OtherProgram& other,
                                    const Scene& scene,
                                    const DiscreteTask& task, double cap);

}  // namespace brachisto::benchmarks
