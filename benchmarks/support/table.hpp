// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What benchmarks say to people.

#pragma once

#include <string>

#include "comparison/statistics.hpp"
#include "report/figure.hpp"
#include "report/text_table.hpp"

namespace brachisto::benchmarks {

using comparison::percentile;
using report::markdown_table;
using report::Rows;

/// Processor, compiler and versions in one line, for the foot of a table.
[[nodiscard]] std::string machine();

/// \throws std::runtime_error if the file cannot be written
void write_file(const std::string& path, const std::string& content);

/// The table, the script and, where gnuplot is, the picture of a figure.
/// \param path  of its files, without ending; the last part is the figure's
/// name \throws std::runtime_error if a file cannot be written
void write_figure(const report::Figure& figure, const std::string& path);

}  // namespace brachisto::benchmarks
