// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Methods by name, and what they are run with.

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/run/solve_options.hpp"

namespace brachisto::comparison {

/// "rolling_time p = 3", "fsolve rest".
[[nodiscard]] std::string label(const ComparedMethod& method);

/// Without spaces: "rolling_time_3", "fsolve_rest".
[[nodiscard]] std::string identifier(const ComparedMethod& method);

/// Whether a mesh makes a difference to it.
[[nodiscard]] bool has_meshes(const ComparedMethod& method);

/// What one point of a method's line is run with.
struct Fineness {
  int mesh = 0;                          ///< 0: it has none
  std::optional<double> tolerance = {};  ///< of Adaptive alone
};
/// "40", "1e-06"; empty where there is nothing to choose.
[[nodiscard]] std::string text(const Fineness& fineness);

/// The points of its line. Meshes below smallest_mesh() are left out.
[[nodiscard]] std::vector<Fineness> points_of(const ComparedMethod& method,
                                              const WorkPrecisionPlan& plan);

/// Who competes with it, as a sentence names them: all degrees of collocation
/// and the adaptive one are "the program", all arms "fsolve".
[[nodiscard]] std::string party(const ComparedMethod& method);

/// The smallest mesh on which there is something to compare.
[[nodiscard]] int smallest_mesh(const ComparedMethod& method);

/// The order of τ that theory promises in the size of the mesh: 2p of Gauss's
/// rule, 2p − 1 of Radau's, which stands for it under limits. Nothing where it
/// promises none.
[[nodiscard]] std::optional<int> promised_order(const ComparedMethod& method,
                                                bool limited);

/// Options of this method for one point. Of the options of the problem it takes
/// the limits and, where it has them, tolerance, linear solver, polishing and
/// the reading of the discrete system. All methods start from the cycloid.
[[nodiscard]] SolveOptions options_of(const ComparedMethod& method,
                                      const Fineness& fineness,
                                      const SolveOptions& base);

}  // namespace brachisto::comparison
