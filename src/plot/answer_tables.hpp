// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// A result document as tables of a page: every key of it has its place, with
/// the words of the table of keys.

#pragma once

#include <string>

#include "report/result_texts.hpp"

namespace brachisto::plot {

/// Of a result document; each is HTML, and empty if there is nothing to tell.
/// Keys that the document lacks are passed over, so that older ones do too.
[[nodiscard]] std::string asked_table(const report::Json& result);
[[nodiscard]] std::string found_table(const report::Json& result);
[[nodiscard]] std::string limits_table(const report::Json& result);
[[nodiscard]] std::string sensitivities_tables(const report::Json& result);
[[nodiscard]] std::string certificate_table(const report::Json& result);
/// How the answer was found: all keys that no other part tells.
[[nodiscard]] std::string way_tables(const report::Json& result);
/// Versions and options.
[[nodiscard]] std::string provenance_tables(const report::Json& result);

/// Text in which letters behind the underscore of a symbol are lowered: "R_n",
/// "β_end", but not "scene.path_limits"; and signs of numbers are real ones.
[[nodiscard]] std::string symbols_html(std::string_view text);
/// A list of such texts, ": one; another"; "" without any.
[[nodiscard]] std::string reasons_html(const report::Json& json,
                                       std::string_view key);

}  // namespace brachisto::plot
