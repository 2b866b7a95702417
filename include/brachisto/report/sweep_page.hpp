// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep as a page to read.

#pragma once

#include <vector>

#include "brachisto/report/output_files.hpp"
#include "brachisto/study/sweep_table.hpp"

namespace brachisto::report {

/// Files of the report of a sweep: index.html, which needs nothing beside it,
/// and each of its figures as an SVG document with a CSV file of its numbers.
///
/// The two ordered axes that change fastest make a map of τ, one ordered axis a
/// curve, a random sample one scatter plot per key. Scenes that failed are
/// marked and nothing is drawn across them; scenes not run yet stay open.
[[nodiscard]] std::vector<OutputFile> sweep_report(const SweepTable& table);

}  // namespace brachisto::report
