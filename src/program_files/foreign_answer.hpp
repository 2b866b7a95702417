// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What another solver says of a program that was written for it, checked as
/// our own answers are.

#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/study/solution.hpp"
#include "brachisto/trajectory/motion.hpp"
#include "program_files/solved_program.hpp"

namespace brachisto::program_files {

/// A .sol file, which solvers of AMPL's family write [Gay2005], in the order of
/// the .nl file.
struct SolFile {
  std::string message;              ///< the solver's own words
  std::vector<double> multipliers;  ///< AMPL's, ∂f/∂(bound); may be missing
  std::vector<double> variables;    ///< may be missing
  int num_constraints = 0, num_variables = 0;  ///< of the program
  std::optional<int> code;  ///< below 200: solved, in AMPL's words
};

/// \throws io::IoError     if it cannot be read
/// \throws io::InputError  if it is no .sol file in text, naming the line
[[nodiscard]] SolFile read_sol(const std::filesystem::path& file);

/// The answer of another solver beside our own.
struct CheckedAnswer {
  std::string solver;         ///< its message, one line
  std::optional<int> code;    ///< as SolFile has it
  double transit_time = 0.0;  ///< T [s]
  double difference = 0.0;    ///< of T, relative to our own
  double farthest = 0.0;  ///< largest difference of an unknown, natural units
  std::string farthest_variable;
  double our_error = 0.0;  ///< estimated, relative, of our own T
  Certificate certificate;

  [[nodiscard]] nlohmann::ordered_json to_json() const;
  [[nodiscard]] std::string in_words() const;
};

/// Residuals, bounds at and between the nodes, second order, conservation and
/// ends of an answer to the program of `solution`, and the check "agreement":
/// its T against our own, to within both errors.
///
/// \param program  of `solution`
/// \param source   the name of the file, for messages
/// \throws io::InputError  if the file is of another program, of another size,
///                         without variables, or no point of the program
[[nodiscard]] CheckedAnswer check_answer(const Solution& solution,
                                         const SolvedProgram& program,
                                         const SolFile& theirs,
                                         const std::string& source);

}  // namespace brachisto::program_files
