// SPDX-FileCopyrightText: 2026 The brachisto authors
// SPDX-License-Identifier: MIT

/// \file
/// What pages with pictures have alike.

#pragma once

#include <cstddef>
#include <string>

#include "report/figure.hpp"

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

}  // namespace brachisto::report
