// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A sweep as a page to read.

#pragma once

#include <vector>

#include "brachisto/report/output_files.hpp"
#include "brachisto/report/sweep_table.hpp"

namespace brachisto::report {

/// Files of the report of a sweep: index.html and each of its figures as an SVG
/// document with a CSV file of its numbers. The page needs nothing beside it,
/// but that it shows drawings from their files when they take more than a
/// megabyte, as a map of some 20 000 scenes does.
///
/// The two ordered axes that change fastest make a map of τ, one ordered axis a
/// curve, a random sample one scatter plot per key; values may come in any
/// order. Scenes that failed are marked and nothing is drawn across them;
/// scenes not run yet stay open.
[[nodiscard]] std::vector<OutputFile> sweep_report(const SweepTable& table);

}  // namespace brachisto::report
