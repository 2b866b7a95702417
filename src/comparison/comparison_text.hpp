// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Measurements and comparisons as tables of text and as documents.

#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "comparison/comparison.hpp"
#include "comparison/work_precision.hpp"
#include "report/text_table.hpp"

namespace brachisto::comparison {

/// A row for each run.
[[nodiscard]] report::Rows point_rows(const WorkPrecision& found);
/// A row for each method with meshes: its order, or why there is none.
[[nodiscard]] report::Rows order_rows(const WorkPrecision& found);
/// A row for each method.
[[nodiscard]] report::Rows method_rows(const MethodComparison& made);

/// "τ = 5.09344446661800(4) by the extremal method".
[[nodiscard]] std::string reference_text(const Reference& reference);

/// "17 + 12": iterations of the solver and Newton steps, where there are any.
[[nodiscard]] std::string iterations_text(const Measurement& run);

/// Outcome, cause, times and effort of a run; what there is not is null.
[[nodiscard]] nlohmann::ordered_json document_of(const Measurement& run);

}  // namespace brachisto::comparison
