// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// option_errors().

#pragma once

#include <string>
#include <vector>

#include "brachisto/study/solve_options.hpp"

namespace brachisto {

/// What is wrong with the options of a solve, a line each; empty if nothing.
/// Options from a problem file have passed the same bounds before.
[[nodiscard]] std::vector<std::string> option_errors(
    const SolveOptions& options);

}  // namespace brachisto
