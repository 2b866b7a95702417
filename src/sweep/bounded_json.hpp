// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// JSON that somebody else may have written.

#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string_view>

namespace brachisto::sweep {

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
