// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The tables of the reproduction for other programs.

#pragma once

#include <string>
#include <vector>

#include "reproduction/comparison.hpp"

namespace brachisto::reproduction {

/// Ours − paper with its sign and in percent, or that it agrees.
[[nodiscard]] std::string difference_text(const Comparison& row);

// Comma-separated values with a header line; words without markup.
[[nodiscard]] std::string comparison_csv(const std::vector<Comparison>& rows);
[[nodiscard]] std::string claims_csv(const std::vector<Claim>& claims);
[[nodiscard]] std::string cases_csv(const Cases& cases);
[[nodiscard]] std::string orientations_csv(
    const std::vector<OrientationRow>& rows);
[[nodiscard]] std::string boundary_csv(const Findings& found);

}  // namespace brachisto::reproduction
