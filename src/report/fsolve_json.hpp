// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The paper's discrete system in result documents.

#pragma once

#include <nlohmann/json.hpp>

#include "brachisto/study/solve.hpp"

namespace brachisto::report {

/// The words of the readings as in problem files.
[[nodiscard]] const char* name(DiscreteReading::Quadrature quadrature);
[[nodiscard]] const char* name(DiscreteReading::Datum datum);
[[nodiscard]] const char* name(DiscreteReading::Slopes slopes);
[[nodiscard]] const char* name(FsolveVariant variant);

[[nodiscard]] nlohmann::ordered_json fsolve_options_json(
    const FsolveOptions& options);

/// What the discrete system came to, beside the extremal's τ; null with other
/// methods. Its numbers are those of another problem than the scene's.
[[nodiscard]] nlohmann::ordered_json fsolve_json(const Solution& solution);

}  // namespace brachisto::report
