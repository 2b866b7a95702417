// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Tables and numbers for people: no digit beyond the error.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::report {

/// Cells; the first row is the head.
using Rows = std::vector<std::vector<std::string>>;

/// Rows of equal length in columns two spaces apart, without spaces at the end
/// of a line. Columns are right-aligned, but for the first and the last.
[[nodiscard]] std::string text_table(const Rows& rows);

/// The same as Markdown, left-aligned; a bar in a cell stays a bar.
[[nodiscard]] std::string markdown_table(const Rows& rows);

enum class TableForm { Text, Markdown };
[[nodiscard]] std::string table(const Rows& rows, TableForm form);

/// A number as text, "—" if there is none.
[[nodiscard]] std::string or_dash(const std::optional<int>& value);

/// "1 step", "2 steps".
[[nodiscard]] std::string counted(std::size_t count, std::string_view what);

/// "0.0123" seconds, to three digits.
[[nodiscard]] std::string seconds_text(double seconds);

/// "38 MB", or "—" if nothing is known.
[[nodiscard]] std::string memory_text(double bytes);

/// A value with its digits up to the error and the error in units of the last
/// one, rounded up: "5.09344446660(5)" is 5.0934444666 ± 5e-11. With an error
/// that is not known, or none, 12 digits and nothing behind them.
/// \param error  absolute, of the value
[[nodiscard]] std::string with_error(double value, double error);

/// The digits of a value that its error leaves, without the error: "5.0934".
[[nodiscard]] std::string within_error(double value, double error);

/// "1.5e-12": two digits that are not below a positive bound.
[[nodiscard]] std::string at_most(double bound);

void add_line(std::string& out, std::string_view label,
              const std::string& text);

/// A table, with the label before its first row.
void add_table(std::string& out, std::string_view label, const Rows& rows);

}  // namespace brachisto::report
