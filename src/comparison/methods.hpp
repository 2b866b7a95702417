// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Methods by name, and as keys of a problem file.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brachisto/io/problem_file.hpp"
#include "brachisto/study/work_precision_plan.hpp"

namespace brachisto::comparison {

/// "rolling_time p = 3", "fsolve rest".
[[nodiscard]] std::string label(const ComparedMethod& method);

/// Without spaces: "rolling_time_3", "fsolve_rest".
[[nodiscard]] std::string identifier(const ComparedMethod& method);

/// Whether the key of a problem file may have that value.
[[nodiscard]] bool accepts(std::string_view key, std::string_view word);

/// Whether this program has the method.
[[nodiscard]] bool available(const ComparedMethod& method);

/// Whether a mesh makes a difference to it.
[[nodiscard]] bool has_meshes(const ComparedMethod& method);

/// The smallest mesh on which there is something to compare.
[[nodiscard]] int smallest_mesh(const ComparedMethod& method);

/// The order of τ that theory promises in the size of the mesh; nothing where
/// it promises none.
[[nodiscard]] std::optional<int> promised_order(const ComparedMethod& method);

/// What makes the problem one of this method on that mesh, in the place of all
/// that it says of discretisation and solver but for its tolerance, linear
/// solver, limits and reading of the discrete system. All start from the
/// cycloid.
[[nodiscard]] std::vector<std::string> overrides(const ComparedMethod& method,
                                                 int mesh,
                                                 const io::ProblemFile& base);

}  // namespace brachisto::comparison
