// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// τ against one key of a sweep.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "report/colour_map.hpp"
#include "report/sweep_scenes.hpp"

namespace brachisto::report {

/// What a plot shows: τ of scenes against a column, which may be of words.
struct XyPlot {
  std::size_t x_column = 0;
  /// One group of scenes per curve, in the order they are joined.
  std::vector<Scenes> curves;
  /// The column that tells the curves apart and labels them.
  std::optional<std::size_t> family;
  bool joined = true;  ///< by lines, with a gap at each scene that failed
  /// Columns to be told in the heading: the same for all its scenes.
  std::vector<std::size_t> fixed;
};

/// Curves or dots, open where a scene is infeasible; failed scenes are crosses
/// on the axis (class "failed"), one row per curve; the smallest value of a
/// feasible scene has a filled ring (class "minimum"), and that of all, if it
/// is smaller, an open one (class "infeasible-minimum"). Dots of a word are
/// spread about it, by a rule, not at random.
///
/// \param range  of τ; common to plots that are to be compared
[[nodiscard]] std::string xy_plot_svg(const SweepTable& table,
                                      const XyPlot& plot, ValueRange range);

}  // namespace brachisto::report
