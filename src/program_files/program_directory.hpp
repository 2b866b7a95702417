// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The files of a program, and what they say of themselves.

#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "program_files/solved_program.hpp"

namespace brachisto::program_files {

enum class ProgramFormat { Nl, Matrices };

/// Where a solver that reads the program begins.
enum class ProgramStart { Guess, Answer };

struct ProgramOutput {
  ProgramFormat format = ProgramFormat::Nl;
  /// Of Nl the .nl file, with names that differ in their ending beside it; of
  /// Matrices a directory.
  std::filesystem::path path;
  ProgramStart start = ProgramStart::Guess;
  bool force = false;  ///< replace files that exist

  [[nodiscard]] std::filesystem::path directory() const;
  /// In the order in which they are written.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Writes all files or none.
/// \return what they hold, which the .json file says
/// \throws report::OutputError
nlohmann::ordered_json write_program(const SolvedProgram& program,
                                     const ProgramOutput& output);

}  // namespace brachisto::program_files
