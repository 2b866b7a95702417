// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Comparisons as pages.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "brachisto/report/result.hpp"
#include "comparison/comparison.hpp"
#include "comparison/work_precision.hpp"

namespace brachisto::comparison {

/// What is to be written of a comparison.
struct ComparisonFiles {
  /// A document with all there is, each picture with its numbers and script,
  /// and the page, index.html, last.
  std::vector<report::OutputFile> files;
  std::string missing;  ///< why pictures are missing; empty if none is
};

/// Names of the files that there may be, of which the last one is written last.
[[nodiscard]] std::vector<std::string> work_precision_file_names();
[[nodiscard]] std::vector<std::string> comparison_file_names();

/// The page has the result in one sentence, then the picture, then what failed
/// and why, and the tables folded. It is well-formed XML too.
/// \param interrupt  nonzero: stop; may be null
/// \throws Stopped
[[nodiscard]] ComparisonFiles files_of(const WorkPrecision& found,
                                       const std::atomic<int>* interrupt);
[[nodiscard]] ComparisonFiles files_of(const MethodComparison& made,
                                       const std::atomic<int>* interrupt);

}  // namespace brachisto::comparison
