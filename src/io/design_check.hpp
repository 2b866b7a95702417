// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a design asks of a problem.

#pragma once

#include <string_view>

#include "io/draft.hpp"
#include "io/findings.hpp"
#include "io/yaml_tree.hpp"

namespace brachisto::io {

/// Of a body that rolls and starts with a speed.
inline constexpr std::string_view kNoRatesFromSpeed =
    "the slope at A is an unknown then, and how it moves with the body is not "
    "known";

/// Refuses designs without a body or without a best one, and ways of solving
/// that a design does not go.
void check_design(const YamlValue& root, const Draft& problem,
                  Findings& findings);

}  // namespace brachisto::io
