// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Methods by name, and what they are run with.

#pragma once

#include <optional>
#include <string>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/solve_options.hpp"

namespace brachisto::comparison {

/// "rolling_time p = 3", "fsolve rest".
[[nodiscard]] std::string label(const ComparedMethod& method);

/// Without spaces: "rolling_time_3", "fsolve_rest".
[[nodiscard]] std::string identifier(const ComparedMethod& method);

/// Whether a mesh makes a difference to it.
[[nodiscard]] bool has_meshes(const ComparedMethod& method);

/// The smallest mesh on which there is something to compare.
[[nodiscard]] int smallest_mesh(const ComparedMethod& method);

/// The order of τ that theory promises in the size of the mesh; nothing where
/// it promises none.
[[nodiscard]] std::optional<int> promised_order(const ComparedMethod& method);

/// Options of this method on that mesh. Of the options of the problem it takes
/// the limits and, where it has them, tolerance, linear solver, polishing and
/// the reading of the discrete system. All methods start from the cycloid.
[[nodiscard]] SolveOptions options_of(const ComparedMethod& method, int mesh,
                                      const SolveOptions& base);

}  // namespace brachisto::comparison
