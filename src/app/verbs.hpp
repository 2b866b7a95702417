// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The verbs of the command, one source file each.

#pragma once

#include "app/command_line.hpp"

namespace brachisto::app {

/// Each adds its verb to the command.
void add_solve(Command& command);
void add_validate(Command& command);
void add_schema(Command& command);
void add_sweep(Command& command);
void add_export(Command& command);
void add_merge(Command& command);
void add_report(Command& command);
void add_paper(Command& command);
void add_body(Command& command);
void add_compare(Command& command);
void add_work_precision(Command& command);
void add_worker(Command& command);   ///< for sweeps, not for people
void add_measure(Command& command);  ///< for comparisons, not for people

}  // namespace brachisto::app
