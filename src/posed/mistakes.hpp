// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What can be said of a problem's formulas before and after a search.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "brachisto/posed/problem.hpp"
#include "posed/mesh_path.hpp"

namespace brachisto::ocp {

/// \throws std::invalid_argument  a sentence, for options that are out of their
///         ranges, a control on which nothing depends, and a limit that what is
///         given at an end breaks
void check(const Posed& problem, const SolveBy& by);

/// Of what evaluate() puts out: "the rate of v".
[[nodiscard]] std::string formula_name(const Statement& said, std::size_t i);

/// Which formula is not finite along a path, and where, in words; nothing if
/// all are.
///
/// \param at_start  whether the start is asked too, where no equation holds
[[nodiscard]] std::string not_finite(const Posed& problem, const MeshPath& path,
                                     bool at_start);

/// Which formula changes much as one variable changes by next to nothing, along
/// a path, in words.
[[nodiscard]] std::string not_smooth(const Posed& problem,
                                     const MeshPath& path);

/// Which control is an angle that is a turn farther at a neighbouring point, in
/// words: between the points the path has no sense.
[[nodiscard]] std::string turned(const Posed& problem, const MeshPath& path);

/// If the variables differ much in size, those whose scale is a mere 1, as
/// nothing that is stated tells their size: what to do about them.
[[nodiscard]] std::string size_hint(const Statement& said,
                                    const std::vector<double>& scales);

}  // namespace brachisto::ocp
