// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Room that words take.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brachisto::report {

/// Letters of UTF-8.
[[nodiscard]] std::size_t letters(std::string_view text);

/// Room that so many letters of a sans-serif font need [px], in doubt more.
[[nodiscard]] double width_of(std::size_t letters, double font_size);

/// Words of at most so many letters, the rest as an ellipsis.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t length);

/// A list in lines of at most so many letters, broken after commas.
[[nodiscard]] std::vector<std::string> lines_of(std::string_view list,
                                                std::size_t length);

/// A text in lines of at most so many letters, broken at spaces; a longer word
/// has a line of its own.
[[nodiscard]] std::vector<std::string> words_in_lines(std::string_view text,
                                                      std::size_t length);

/// A dotted key of at most so many letters: what it begins with goes first,
/// "…limits.iterations".
[[nodiscard]] std::string shortened_key(std::string_view key,
                                        std::size_t length);

/// Letters that a line on stderr may have: where that is a terminal, one less
/// than it has columns, for a full row would leave the cursor in the next.
/// 79 if the terminal does not know; what is not written to one may be as long
/// as it likes.
[[nodiscard]] std::size_t columns_for_a_line();

}  // namespace brachisto::report
