// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The order in which an .nl file wants a program's variables and constraints.

#pragma once

#include <span>
#include <vector>

#include "program_files/program_in_formulas.hpp"

namespace brachisto::program_files {

/// A format for programs of any kind asks for variables in this order:
/// nonlinear in constraints and objective, in constraints alone, in the
/// objective alone, linear; for nonlinear constraints before linear ones; and
/// for quantities that constraints and the objective use before those that
/// constraints use and those that the objective does. Otherwise the order is
/// the program's.
///
/// Reads all formulas once.
struct NlNumbering {
  NlNumbering() = default;
  NlNumbering(const nlp::Problem& problem, const ProgramInFormulas& formulas);

  std::vector<int> variables;    ///< the program's, in the file's order
  std::vector<int> constraints;  ///< likewise
  std::vector<int> quantities;   ///< likewise, those that are used
  /// The inverses; −1 of a quantity that is not used.
  std::vector<int> place_of_variable, place_of_quantity;

  int nonlinear_constraints = 0;
  bool nonlinear_objective = false;
  /// Of variables, as the header counts them.
  int nonlinear_in_constraints = 0, nonlinear_in_objective = 0,
      nonlinear_in_both = 0;
  /// Of quantities.
  int used_by_both = 0, used_by_constraints = 0, used_by_objective = 0;

  /// Entries of the Jacobian in each column, by the program's variables.
  std::vector<int> column_entries;
  std::size_t jacobian_entries = 0;
  int gradient_entries = 0;
};

/// The unknowns of a formula, those of its quantities among them, each with its
/// coefficient in the affine part, 0 if it is in the tree alone; in the file's
/// order if it is known. Clears `out` first.
void find_unknowns(const Formula& formula, const ProgramInFormulas& formulas,
                   std::span<const int> place, std::vector<Formula::Term>& out);

}  // namespace brachisto::program_files
