// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Words of others: as a terminal may show them, and as they may be meant.

#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace brachisto::io {

/// Length in bytes of the UTF-8 character at the beginning of `text`, 0 if
/// there is none: Unicode standard, table 3-7 (no overlong forms, no
/// surrogates, nothing above U+10FFFF).
[[nodiscard]] std::size_t character_length(std::string_view text);

/// A text without the byte order mark that some editors put before it.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

/// A name or a word of the input, safe to show: every byte of a control
/// character (C0, DEL, C1), of a separator of lines or of a mark that turns the
/// direction of text, and every byte that is not UTF-8, stands as "\x1b".
///
/// \param most  characters; what follows is cut off, which an ellipsis tells
[[nodiscard]] std::string visible(
    std::string_view text,
    std::size_t most = std::numeric_limits<std::size_t>::max());

/// The same for a text of several lines, whose tabs and line feeds stay.
[[nodiscard]] std::string visible_lines(std::string_view text);

/// Number of insertions, deletions, replacements and swaps of neighbours that
/// turn one word into the other (optimal string alignment), case ignored.
/// O(|a| |b|) in time, O(|b|) in space.
[[nodiscard]] int edit_distance(std::string_view a, std::string_view b);

/// The candidate with the smallest distance to a mistyped word, or "" if none
/// is near: the distance must not exceed a third of the shorter word (rounded
/// up) and must leave something of it.
[[nodiscard]] std::string_view nearest(
    std::string_view word, std::span<const std::string_view> candidates);

/// "; did you mean NEAREST?", or nothing if none is near.
[[nodiscard]] std::string suggestion(
    std::string_view word, std::span<const std::string_view> candidates);

/// Why a word is none of those known: what was read, what is expected, and the
/// nearest one.
[[nodiscard]] std::string unknown_word(std::string_view word,
                                       std::string_view expected,
                                       std::span<const std::string_view> known);

/// Text from an input as it may stand in a message: in quotes, control
/// characters escaped, cut after 40 characters.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// The same without quotes, for keys.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace brachisto::io
