// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What a store keeps of a scene, and its way into tables.

#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "brachisto/study/solve.hpp"
#include "design/design_search.hpp"
#include "report/sweep_table.hpp"

namespace brachisto::sweep {

/// The result document of a solve, compact, without what all scenes of a sweep
/// share.
/// \param with_track  if it is verified, plot::kept_track() of it too, as
///                    `track`
/// With `method: auto` the key `engine` says which way it was solved: `lanes`
/// side by side with others, without mesh and iterations, or `own`.
[[nodiscard]] std::string outcome_json(const Solution& solution,
                                       bool with_track = false);

/// The document of a search: that of its answer, or of its failure, and the
/// search itself under the key `design`.
[[nodiscard]] std::string outcome_json(const DesignSearch& search);
/// The search in such a document.
/// \throws std::exception  of nlohmann::json, if there is none
[[nodiscard]] DesignSearch read_design_search(const std::string& document);

/// The document of a scene that no worker could answer for.
[[nodiscard]] std::string failure_json(std::string_view status,
                                       std::string_view message);

/// Longest document that is kept [bytes].
inline constexpr std::size_t kLongestOutcome = std::size_t{1} << 20U;

/// True if a text is such a document: read_outcome() has what it needs. Other
/// readers may rely on the bounds of parse_bounded_json().
[[nodiscard]] bool is_outcome(const std::string& document);

/// What a table shows of a document that satisfies is_outcome().
[[nodiscard]] SweepOutcome read_outcome(const std::string& document);
/// The same of one that may be something else; then nothing.
[[nodiscard]] std::optional<SweepOutcome> find_outcome(
    const nlohmann::ordered_json& document);

/// Deepest nesting of maps and lists that is read. Copies and texts of a
/// document are made recursively.
inline constexpr int kDeepestJson = 32;

/// Most values in a document. A map looks for each of its keys among all of
/// them.
inline constexpr std::size_t kMostJsonValues = 20'000;

/// The document, or nothing if the text is no JSON or exceeds these bounds.
[[nodiscard]] std::optional<nlohmann::ordered_json> parse_bounded_json(
    std::string_view text);

}  // namespace brachisto::sweep
