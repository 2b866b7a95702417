// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A program as an .nl file, which solvers of AMPL's family read [Gay2005].

#pragma once

#include "brachisto/nlp/problem.hpp"
#include "program_files/nl_numbering.hpp"
#include "program_files/text_stream.hpp"

namespace brachisto::program_files {

/// Writes the program as text ("g" format), formula after formula.
///
/// A constraint is the program's own g_i between its bounds, but for the
/// constant of a linear one, which goes to the bounds. The multipliers of the
/// start are AMPL's, ∂f/∂(bound) = −λ.
///
/// \param start  where a solver begins; multipliers if it has some
void put_nl(const nlp::Problem& problem, const ProgramInFormulas& formulas,
            const NlNumbering& numbering, const PrimalDual& start,
            TextStream& out);

/// Names of the constraints and the objective, one a line (.row), and of the
/// variables (.col), in the file's order.
void put_row_names(const nlp::Problem& problem, const NlNumbering& numbering,
                   TextStream& out);
void put_col_names(const nlp::Problem& problem, const NlNumbering& numbering,
                   TextStream& out);

/// A name as these files have it, without spaces: "defect_of_theta[7]".
[[nodiscard]] std::string word_of(std::string name);

}  // namespace brachisto::program_files
