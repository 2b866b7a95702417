// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// Words with subscripts and superscripts, for drawings, pages and scripts.

#pragma once

#include <string>
#include <string_view>

namespace brachisto::report {

/// In the source an underscore or a caret lowers or raises the letter, or the
/// group in braces, that follows: "η_m", "10^{-6}"; after a backslash they
/// stand for themselves. Everything else is as it stands, and escaped for where
/// it goes.
[[nodiscard]] std::string html_words(std::string_view source);
/// For enhanced text within single quotes.
[[nodiscard]] std::string gnuplot_words(std::string_view source);
/// Without the marks.
[[nodiscard]] std::string plain_words(std::string_view source);

/// The source of a text that shows it as it is.
[[nodiscard]] std::string as_rich_text(std::string_view text);

/// With every `old` in a text replaced.
[[nodiscard]] std::string replaced(std::string_view text, std::string_view old,
                                   std::string_view by);

/// Text as content or attribute value of XML and HTML. Characters that XML
/// does not have become U+FFFD.
[[nodiscard]] std::string xml_escaped(std::string_view text);

}  // namespace brachisto::report
