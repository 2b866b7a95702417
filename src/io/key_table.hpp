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

/// A JSON Schema of problem files, made from the same table. It knows keys,
/// types, words and the bounds of single values; what keys demand of each other
/// the reader alone knows.
[[nodiscard]] std::string problem_schema();

}  // namespace brachisto::io
