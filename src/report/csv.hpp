// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Fields of comma-separated values.

#pragma once

#include <string>
#include <string_view>

namespace brachisto::report {

/// True if a spreadsheet would take a text for a formula, =, +, − or @ first,
/// perhaps behind a tab or an end of line.
[[nodiscard]] bool begins_as_formula(std::string_view text);

/// A text as a field (RFC 4180): within quotes if it has to be. Before what
/// begins as a formula stands an apostrophe. Not for numbers, whose minus is a
/// sign.
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace brachisto::report
