// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A store as tables.

#pragma once

#include <cstddef>
#include <string>

#include "plot/sweep_data.hpp"
#include "report/sweep_table.hpp"
#include "sweep/job.hpp"
#include "sweep/store.hpp"

namespace brachisto::sweep {

/// All scenes of the store's sweep with what came out.
[[nodiscard]] SweepTable read_table(Store& store, const Job& job);

/// The tracks that it kept; none of a sweep without `keep: tracks`.
[[nodiscard]] std::vector<plot::SweepTrack> read_tracks(Store& store,
                                                        const Job& job);

/// A table as text.
struct ExportedTable {
  std::string text;
  std::size_t rows = 0;
};

/// Flat tables of the scenes that have a result: number, swept keys, and the
/// figures of the result document in as many digits as tell doubles apart,
/// empty or null where there is none.
[[nodiscard]] ExportedTable export_csv(Store& store, const Job& job);
[[nodiscard]] ExportedTable export_json(Store& store, const Job& job);
/// The same for people, to ten digits, a dash where there is none.
[[nodiscard]] ExportedTable export_markdown(Store& store, const Job& job);

}  // namespace brachisto::sweep
