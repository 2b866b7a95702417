// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Two axes of a sweep as a map.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/colour_map.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// What a map shows: scene (i, j) is scenes[i · ny + j] and lies where its own
/// values of two numeric columns put it; see in_map_order().
struct SweepMap {
  std::size_t x_column = 0, y_column = 0;
  std::size_t nx = 0, ny = 0;  ///< both at least 2
  Scenes scenes;
  std::string name;  ///< letters, digits and hyphens; unique within a page
  /// Columns to be told in the heading: the same for all its scenes.
  std::vector<std::size_t> fixed;
};

/// Colours of τ with contour lines through verified scenes, the smallest value
/// of a feasible one marked (class "minimum"), and that of all, if it is
/// smaller (class "infeasible-minimum"). Failed scenes are hatched (class
/// "failed"), missing ones open (class "missing"); a line surrounds what is
/// infeasible.
///
/// \param range  of the colours; common to maps that are to be compared
[[nodiscard]] std::string heat_map_svg(const SweepTable& table,
                                       const SweepMap& map, ValueRange range);

/// The same map with two greys for feasible and infeasible scenes.
[[nodiscard]] std::string feasibility_map_svg(const SweepTable& table,
                                              const SweepMap& map);

}  // namespace brachisto::report
