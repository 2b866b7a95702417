// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What the documents of comparisons share.

#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "comparison/comparison.hpp"

namespace brachisto::comparison {

/// The value, or null.
template <class Value>
[[nodiscard]] nlohmann::ordered_json or_null(
    const std::optional<Value>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// Outcome, cause, times and effort of a run; what there is not is null.
[[nodiscard]] nlohmann::ordered_json to_json(const Measurement& run);

[[nodiscard]] nlohmann::ordered_json to_json(
    const std::optional<Reference>& reference);

/// The keys `machine`, `provenance` and `scene`.
void add_origin(nlohmann::ordered_json& document, const Subject& subject);

/// "τ = 5.09344446661800(4) by the extremal method".
[[nodiscard]] std::string reference_text(const Reference& reference);

/// "1.6e-06", or that it is less than the reference can tell.
[[nodiscard]] std::string error_text(double error, const Reference& reference);

/// "17 + 12": iterations of the solver and Newton steps, where there are any.
[[nodiscard]] std::string iterations_text(const Measurement& run);

struct Machine {
  std::string cpu;     ///< model, by the kernel; "unknown" if it does not say
  std::string kernel;  ///< "Linux 6.1.0 x86_64"
  int cores = 0;       ///< that this process may use
};

[[nodiscard]] Machine this_machine();

}  // namespace brachisto::comparison
