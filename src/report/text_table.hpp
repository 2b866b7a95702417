// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Tables for people.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace brachisto::report {

/// Cells; the first row is the head.
using Rows = std::vector<std::vector<std::string>>;

/// Rows of equal length in columns two spaces apart, without spaces at the end
/// of a line. Columns are right-aligned, but for the first and the last.
[[nodiscard]] std::string text_table(const Rows& rows);

/// The same as Markdown, left-aligned.
[[nodiscard]] std::string markdown_table(const Rows& rows);

/// A number as text, "—" if there is none.
[[nodiscard]] std::string or_dash(const std::optional<int>& value);

/// "0.0123" seconds, to three digits.
[[nodiscard]] std::string seconds_text(double seconds);

/// "38 MB", or "—" if nothing is known.
[[nodiscard]] std::string memory_text(double bytes);

}  // namespace brachisto::report
