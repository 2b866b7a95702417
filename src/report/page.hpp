// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What pages with pictures or scripts have alike.

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "report/figure.hpp"
#include "report/result_texts.hpp"
#include "report/text_table.hpp"

namespace brachisto::report {

/// A page up to the end of its head and the beginning of its body.
/// \param title  HTML
/// \param more   of the head, HTML
[[nodiscard]] std::string document_head(const std::string& title,
                                        const std::string& more);

/// The page up to its first heading.
/// \param title  HTML
/// \param more   of the heading, HTML
[[nodiscard]] std::string page_head(const std::string& title,
                                    const std::string& more = {});

/// Bytes of pictures that a page may hold.
inline constexpr std::size_t kMostOfPictures = 4'000'000;

/// A picture with its caption and links to its files; why there is none, if so.
/// \param caption  HTML
/// \param room     bytes left on the page: a picture that needs more is shown
///                 from its file
[[nodiscard]] std::string figure_html(const DrawnFigure& drawn,
                                      const std::string& name,
                                      const std::string& caption,
                                      std::size_t& room);

/// A table of text, as blocks of lines on a narrow screen.
[[nodiscard]] std::string html_table(const Rows& rows);

/// What is folded until its summary is pressed.
/// \param content  HTML
[[nodiscard]] std::string folded_html(std::string_view summary,
                                      const std::string& content);

/// A script within a page that is XML too.
[[nodiscard]] std::string script_html(std::string_view content);

/// JSON that HTML and XML leave alone.
[[nodiscard]] std::string page_json(const Json& json);

/// The JSON document from which the scripts of a page draw.
[[nodiscard]] std::string data_html(std::string_view json);

/// The controls of the time.
/// \param more  of them, HTML
[[nodiscard]] std::string playback_html(std::string_view more = {});

}  // namespace brachisto::report
