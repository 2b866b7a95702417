// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A trajectory with so few rows that a page can hold them, or a sweep very
/// many of them.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "brachisto/model/body.hpp"
#include "plot/trajectory_table.hpp"
#include "report/result_texts.hpp"
#include "report/scale.hpp"

namespace brachisto::plot {

/// Where the values of a quantity lie but for those that would leave no room
/// for the others, as curvatures do that grow without bound: from the first to
/// the last percentile of the finite values, or of all if that takes at most
/// three times as much; without the first fiftieth of the time, in which forces
/// and curvatures run towards limits of their own. From 0 to 0 if there are
/// none.
[[nodiscard]] report::Extent shown_range(const TrajectoryTable& table,
                                         const std::vector<double>& values);

/// A quantity that a page shows as a curve.
struct ShownCurve {
  std::string column;
  report::Extent range;
};

/// A table of some rows of another one, and by how much it misses the others.
struct ThinnedTable {
  TrajectoryTable table;
  std::size_t of_rows = 0;   ///< of the other one
  double path_error = 0.0;   ///< largest, of the centre and of the contact [m]
  double curve_error = 0.0;  ///< largest, as share of the range shown
};

/// Curves that are off by more, as share of their range, show no turn any more.
inline constexpr double kCoarsest = 0.05;

/// All rows if they are `most` or fewer. Otherwise those with which the error
/// is about the smallest, the first and the last one among them; if it would be
/// more than kCoarsest all the same, rows at equal steps, so that the place is
/// right and curves show at least between which values they run. The errors are
/// those at all rows left out. O(n log n).
[[nodiscard]] ThinnedTable thinned(const TrajectoryTable& table,
                                   const Body& body,
                                   const std::vector<ShownCurve>& curves,
                                   std::size_t most);

/// Distance by which a kept track may miss a row that it leaves out, centre and
/// contact, as share of the larger side of what the track takes: half a pixel
/// of a drawing. Rounding comes on top, a hundredth of that.
inline constexpr double kKeptError = 5e-4;
/// Most rows; the error of a track that needs more is told like all others.
inline constexpr std::size_t kMostKeptRows = 90;

/// Rows that keep to kKeptError, few of them, as
///
///     {"of_rows": …, "path_error": …, "lifts": [[from, to], …],
///      "steps": […], "rows": [[…], …]}
///
/// with path_error [m] the largest distance at all rows of the table, that of
/// rounding included; the times between which R_n ≤ 0; and one list for each of
/// t, x_c, z_c, beta, v_c and, unless it is a bead, theta: the first value and
/// then the differences from row to row, in units of the column's step, a power
/// of ten.
[[nodiscard]] report::Json kept_track(const TrajectoryTable& table,
                                      const Body& body);

/// The rows of such a document, with these columns and omega; nothing if it is
/// none.
[[nodiscard]] std::optional<TrajectoryTable> read_kept_track(
    const report::Json& track, const Body& body);

}  // namespace brachisto::plot
