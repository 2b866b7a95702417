// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Results as JSON, the form that other programs read.

#pragma once

#include <string>

#include "brachisto/study/solve.hpp"

namespace brachisto::report {

/// Version of the layout of result documents; grows when a key changes its
/// meaning. New keys may come at any time.
inline constexpr int kSchemaVersion = 2;

/// The document of one solve. Numbers of the path are null unless the result is
/// verified; so is whatever the scene does not have.
[[nodiscard]] std::string result_json(const Solution& solution);

/// The reference of its keys as a Markdown table, made from the very table that
/// writes them. docs/results.md quotes it.
[[nodiscard]] std::string result_reference_markdown();

/// A JSON Schema of the document, made from the same table.
[[nodiscard]] std::string result_schema();

/// The effective input, defaults filled in, as `validate --json` prints it.
[[nodiscard]] std::string input_json(const Scene& scene,
                                     const SolveOptions& options);

}  // namespace brachisto::report
