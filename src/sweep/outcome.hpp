// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a store keeps of a scene, and its way into tables.

#pragma once

#include <string>
#include <string_view>

#include "brachisto/study/solve.hpp"
#include "brachisto/study/sweep_table.hpp"

namespace brachisto::sweep {

/// The result document of a solve, compact, without what all scenes of a sweep
/// share.
[[nodiscard]] std::string outcome_json(const Solution& solution);

/// The document of a scene that no worker could answer for.
[[nodiscard]] std::string failure_json(std::string_view status,
                                       std::string_view message);

/// What a table shows of a document.
[[nodiscard]] SweepOutcome read_outcome(const std::string& document);

}  // namespace brachisto::sweep
