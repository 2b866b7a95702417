// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Comparisons as pages.

#pragma once

#include <atomic>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/work_precision.hpp"
#include "report/figure.hpp"

namespace brachisto::comparison {

/// Names of the files that there may be, of which the last one is written last.
[[nodiscard]] std::vector<std::string> work_precision_file_names();
[[nodiscard]] std::vector<std::string> comparison_file_names();

/// A document with all there is, each picture with its numbers and script, and
/// last the page, index.html. It has the result in one sentence, then the
/// picture, then what failed and why, and the tables folded. It is well-formed
/// XML too.
///
/// \param interrupt  nonzero: stop; may be null
/// \throws Stopped
[[nodiscard]] report::DrawnFiles files_of(const WorkPrecision& found,
                                          const std::atomic<int>* interrupt);
[[nodiscard]] report::DrawnFiles files_of(const MethodComparison& made,
                                          const std::atomic<int>* interrupt);

}  // namespace brachisto::comparison
