// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// "Did you mean …?"

#pragma once

#include <span>
#include <string>
#include <string_view>

namespace brachisto::io {

/// Number of insertions, deletions, replacements and swaps of neighbours that
/// turn one word into the other (optimal string alignment), case ignored.
/// O(|a| |b|) in time, O(|b|) in space.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest distance to a mistyped word, or "" if none
/// is near: the distance must not exceed a third of the longer word (rounded
/// up) and must leave something of it.
[[nodiscard]] std::string_view nearest(
    std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean NEAREST?", or nothing if none is near.
[[nodiscard]] std::string suggestion(
    std::string_view word, std::span<const std::string_view> candidates);

}  // namespace brachisto::io
