// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The numbers of a sweep as a table for other programs.

#pragma once

#include <string>

#include "brachisto/report/sweep_table.hpp"

namespace brachisto::report {

/// Comma-separated values with a header line (RFC 4180 with newlines), one
/// row per scene: its number, its keys in SI units and radians, state, status,
/// feasible, tau, transit_time, estimated_error, end_angle and message; 17
/// digits; what a scene does not have stays empty.
[[nodiscard]] std::string sweep_csv(const SweepTable& table);

}  // namespace brachisto::report
