// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Comma-separated values: fields, and the scenes of a sweep.

#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "report/sweep_table.hpp"

namespace brachisto::report {

/// A text as a field (RFC 4180): within quotes if it has to be. Before what
/// begins as a formula stands an apostrophe. Not for numbers, whose minus is a
/// sign.
[[nodiscard]] std::string csv_field(std::string_view text);

/// A row with its end: a field of each item.
/// \pre  there are items
[[nodiscard]] std::string csv_row(const auto& items, const auto& field_of) {
  std::string out;
  for (const auto& item : items) {
    out += std::invoke(field_of, item);
    out += ',';
  }
  out.back() = '\n';
  return out;
}

/// Comma-separated values with a header line (RFC 4180 with newlines), one
/// row per scene: its number, its keys in SI units and radians, state, status,
/// feasible, tau, transit_time, estimated_error, end_angle and message; 17
/// digits; what a scene does not have stays empty.
[[nodiscard]] std::string sweep_csv(const SweepTable& table);

}  // namespace brachisto::report
