// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The lines of a summary: a label and what is told under it.

#pragma once

#include <string>
#include <string_view>

#include "report/text_table.hpp"

namespace brachisto::report {

void add_line(std::string& out, std::string_view label,
              const std::string& text);

/// A table, with the label before its first row.
void add_table(std::string& out, std::string_view label, const Rows& rows);

}  // namespace brachisto::report
