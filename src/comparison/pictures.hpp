// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Comparisons as pictures.

#pragma once

#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/work_precision.hpp"
#include "report/figure.hpp"

namespace brachisto::comparison {

struct Picture {
  report::Figure figure;
  std::string caption;  ///< one sentence or two
};

/// Processor time against the error of τ, with and without the start, that of
/// the path, and the energy drift, as far as there is anything to show.
[[nodiscard]] std::vector<Picture> pictures_of(const WorkPrecision& found);
/// Names of the files that there may be of these.
[[nodiscard]] std::vector<std::string> work_precision_picture_files();

/// Processor time against the error of τ, a named mark for each method. Without
/// a reference there are no errors, and no picture.
[[nodiscard]] std::vector<Picture> pictures_of(const MethodComparison& made);

/// The body, its track and its limits.
[[nodiscard]] std::string in_words(const Subject& subject);

}  // namespace brachisto::comparison
