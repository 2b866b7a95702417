// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep as a page to read and to point at.

#pragma once

#include <atomic>
#include <vector>

#include "plot/sweep_data.hpp"
#include "report/figure.hpp"
#include "report/sweep_table.hpp"

namespace brachisto::plot {

/// The report of a sweep: each picture as an SVG document with the table and
/// the gnuplot script that it is drawn from, scenes.csv, and index.html.
///
/// The page needs nothing beside it, but that it shows pictures from their
/// files when all take more than some megabytes. It is well-formed XML too.
///
/// The two ordered axes that change fastest make a map of τ, one ordered axis a
/// curve, a random sample one scatter plot per key; values may come in any
/// order. Scenes that failed are marked and nothing is drawn across them;
/// scenes not run yet stay open.
///
/// Over the pictures lie the scenes as cells that tell their values and, if it
/// was kept, show their track, unless there are more than kMostRows.
///
/// \param tracks     in the order of scenes
/// \param interrupt  nonzero: stop; may be null
/// \throws Stopped
[[nodiscard]] report::DrawnFiles sweep_report(
    const SweepTable& table, const std::vector<SweepTrack>& tracks,
    const std::atomic<int>* interrupt);

/// Scenes that a page lists.
inline constexpr std::size_t kMostRows = 3000;

}  // namespace brachisto::plot
