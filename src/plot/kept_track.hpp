// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A track in some hundred bytes, so that a page holds thousands of them: what
/// a sweep keeps of its scenes.

#pragma once

#include <cstddef>
#include <optional>

#include "brachisto/model/body.hpp"
#include "plot/trajectory_table.hpp"
#include "report/result_field.hpp"

namespace brachisto::plot {

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
