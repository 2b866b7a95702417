// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The manual, made from the tables that the help and the reader of problem
// files are made from.

#pragma once

#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "brachisto/report/output_files.hpp"

namespace brachisto::app {

/// "--out DIR", in roff.
[[nodiscard]] std::string heading_of(const Flag& flag);

/// brachisto.1 and a page for each verb, brachisto-solve.1 and so on.
[[nodiscard]] std::vector<report::OutputFile> command_pages(
    const CommandLine& command);

/// brachisto-problem.5: every key of a problem file.
[[nodiscard]] report::OutputFile problem_page();

}  // namespace brachisto::app
