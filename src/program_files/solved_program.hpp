// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The nonlinear program that a solve ended on.

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solution.hpp"
#include "model/units.hpp"
#include "transcription/transcription.hpp"

namespace brachisto::program_files {

/// A program in natural units, between the end points of the centre that the
/// solve closed the contacts with: the tangency condition is none of its
/// constraints.
struct SolvedProgram {
  std::unique_ptr<Transcription> problem;
  PrimalDual answer;
  /// Where a solve may begin: on the cycloid, or what solver.guess asks for,
  /// without multipliers; of straight pieces on an extremal of a coarse mesh,
  /// with its multipliers.
  PrimalDual guess;
  Units units;
  /// φ that C_B is built from; nothing where the program has free contacts.
  std::optional<double> end_slope;

  /// The objective at the answer, in natural units.
  /// \throws std::runtime_error  if it is no point of the program
  [[nodiscard]] double objective() const;
};

/// Why a scene with these options ends on no program; empty if it does.
[[nodiscard]] std::string no_program_because(const Scene& scene,
                                             const SolveOptions& options);

/// \param source  the name of the file
/// \throws io::InputError  with that reason, if there is one
void require_program(const io::ProblemFile& problem, const std::string& source);

/// The program of an answer; under limits that which has them as inequalities.
/// Nothing if there is no answer.
/// \pre no_program_because() has no reason
[[nodiscard]] std::optional<SolvedProgram> solved_program(
    const Solution& solution);

}  // namespace brachisto::program_files
