// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The scenes of a figure as their values follow one another, which is not how
/// a list in a file has to have them.

#pragma once

#include <optional>

#include "report/sweep_plots.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// Scenes by ascending numbers of a column; as they are if it has words.
[[nodiscard]] Scenes sorted_by(const SweepColumn& column, Scenes scenes);

/// Whether no two of these scenes have the same value.
[[nodiscard]] bool distinct(const SweepColumn& column, const Scenes& scenes);

/// The scenes of a map with both axes in an order in which its cells neither
/// overlap nor vanish; none if sorting the axes, each by the mean of what its
/// column says, does not give one, or if a value is there twice.
[[nodiscard]] std::optional<Scenes> in_map_order(const SweepTable& table,
                                                 const SweepMap& map);

}  // namespace brachisto::report
