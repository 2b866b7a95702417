// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// The keys of problem files, described.

#pragma once

#include <string>

namespace brachisto::io {

/// The reference of all keys as a Markdown table, made from the very table
/// that the reader of problem files works with. docs/problem-files.md quotes
/// it.
[[nodiscard]] std::string key_reference_markdown();

}  // namespace brachisto::io
