// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

// The page of a sweep and what goes with it, for the verbs that write it.

#pragma once

#include <string>

namespace brachisto::app {

/// Writes DIR/report.
/// \param force  replaces an earlier one
/// \param quiet  does not list what was written
/// \return the exit code
/// \throws sweep::StoreError, report::OutputError, Stopped
int write_sweep_report(const std::string& directory, bool force, bool quiet);

}  // namespace brachisto::app
