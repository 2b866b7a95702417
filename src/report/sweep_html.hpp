// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Parts of the page of a sweep, as HTML.

#pragma once

#include <string>

#include "report/sweep_figures.hpp"

namespace brachisto::report {

/// The axes with their columns and the values they run over.
[[nodiscard]] std::string axes_table(const SweepTable& table);

/// Counts and extreme values of these scenes.
[[nodiscard]] std::string digest_table(const SweepTable& table,
                                       const Scenes& scenes);

/// The scenes that failed, with their cause, up to a number that can be read;
/// empty if none did.
[[nodiscard]] std::string failures_table(const SweepTable& table);

/// All scenes, folded; of a sweep too large for a page, where to find them.
[[nodiscard]] std::string scenes_table(const SweepTable& table,
                                       const std::string& csv_name);

}  // namespace brachisto::report
