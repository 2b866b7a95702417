// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A measurement as text and as a document.

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparison/measurement.hpp"

namespace brachisto::comparison {

template <class Value>
[[nodiscard]] nlohmann::ordered_json or_null(
    const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// "17 + 12": iterations of the solver and Newton steps, where there are any.
[[nodiscard]] std::string iterations_text(const Measurement& run);

/// Outcome, cause, times and effort of a run; what there is not is null.
[[nodiscard]] nlohmann::ordered_json document_of(const Measurement& run);

}  // namespace brachisto::comparison
